// SPDX-License-Identifier: Apache-2.0
// The memory of a Verilated chip (rtl/memory/memory.vhd): banks that follow one another, each
// with a lane for each byte of a word.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <tuple>

namespace sim {

inline constexpr std::uint32_t memory_start = 0x8000'0000;

// The arrays of a lane (n1 to n4), of a model whose name for them is RAM(part).
#define STEPFABRIC_MEMORY_LANE(root, lane)                                       \
  std::tie((root).RAM(banks_n1_lanes_##lane), (root).RAM(banks_n2_lanes_##lane), \
           (root).RAM(banks_n3_lanes_##lane))

// The byte at this word's place in a lane of the memory, which is so many arrays of the model; null
// beyond their end.
template <typename First, typename... Others>
auto* byte_in_banks(std::uint32_t word, First& first, Others&... others) {
  constexpr std::uint32_t words = sizeof(First);
  using Byte = decltype(&first[0]);
  if (word < words) return &first[word];
  if constexpr (sizeof...(Others) > 0) {
    return byte_in_banks(word - words, others...);
  } else {
    return Byte{};
  }
}

// The bytes of the word at this address, one in each of the lanes. Throws where there is none.
template <typename... Lanes>
auto bytes_of_word(std::uint32_t address, const Lanes&... lanes) {
  const std::uint32_t word = (address - memory_start) / 4;
  const auto byte = [word](auto&... banks) { return byte_in_banks(word, banks...); };
  const std::array bytes{std::apply(byte, lanes)...};
  if (address < memory_start || bytes[0] == nullptr) {
    throw std::out_of_range(fmt::format("no memory at {:#010x}", address));
  }
  return bytes;
}

}  // namespace sim
