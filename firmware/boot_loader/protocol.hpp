// SPDX-License-Identifier: Apache-2.0
// What the boot loader and a host say to each other: frames, their kinds, and their contents.
// Shared by both ends.
//
//   marker  kind  length (2)  payload  CRC-32 (4) of kind, length and payload     lowest byte first
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace boot_loader {

// At the end of the chip's memory, and before that the loader's stack, which no program that is
// loaded may overwrite. firmware/target/CMakeLists.txt reads them here.
inline constexpr std::uint32_t loader_bytes = 2432;
inline constexpr std::uint32_t loader_stack_bytes = 1280;

// No frame and no line of G-code begins with it, and on the wire it is one low bit only: any
// program that begins to listen in the middle of many of them hears nothing else.
inline constexpr std::uint8_t knock = 0xFF;
// So many without another byte between them, and the loader stays.
inline constexpr unsigned knocks = 8;

inline constexpr std::uint8_t marker = 0xB5;
inline constexpr std::size_t header_bytes = 3;  // kind and length
inline constexpr std::size_t checksum_bytes = 4;
inline constexpr std::size_t most_block_bytes = 512;
inline constexpr std::size_t most_payload_bytes = 4 + most_block_bytes;

enum class Kind : std::uint8_t {
  // From the host.
  hello = 'H',  // empty: who is there?
  begin = 'B',  // address, bytes, CRC-32 of all of them, entry: from now on the old program is void
  block = 'D',  // offset from the address, then up to most_block_bytes, in order
  start = 'S',  // empty: check all that came, and begin the program
  // From the loader.
  identity = 'I',  // version, address and bytes of the memory that may be loaded
  accepted = 'A',  // the kind that is accepted, then the offset that is wanted next
  refused = 'R',  // the reason
};

enum class Refusal : std::uint8_t {
  damaged = 1,  // the frame's CRC is wrong, or it stopped in the middle: send it again
  unknown,
  outside,  // the program does not fit, or its entry lies outside of it
  not_begun,
  out_of_order,  // the block does not follow the last one: ask with hello and begin again
  incomplete,
  wrong_checksum  // of the whole: begin again
};

inline constexpr std::uint32_t version = 1;

constexpr std::uint32_t word_at(std::span<const std::uint8_t> bytes, std::size_t place) {
  return static_cast<std::uint32_t>(bytes[place] | bytes[place + 1] << 8 | bytes[place + 2] << 16) |
         std::uint32_t{bytes[place + 3]} << 24;
}

constexpr void put_word(std::span<std::uint8_t> bytes, std::size_t place, std::uint32_t word) {
  for (unsigned i = 0; i < 4; ++i) bytes[place + i] = static_cast<std::uint8_t>(word >> 8 * i);
}

}  // namespace boot_loader
