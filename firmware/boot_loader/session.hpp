// SPDX-License-Identifier: Apache-2.0
// Processes the frames of a host: fills memory, answers, and reports when a program is complete.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "boot_loader/frame_receiver.hpp"
#include "boot_loader/protocol.hpp"

namespace boot_loader {

// An answer with its frame around it.
class Answer {
 public:
  Answer(Kind kind, std::span<const std::uint8_t> payload);
  std::span<const std::uint8_t> bytes() const { return std::span(bytes_).first(count_); }

 private:
  static constexpr std::size_t most_answer_bytes = 12;
  std::array<std::uint8_t, 1 + header_bytes + most_answer_bytes + checksum_bytes> bytes_{};
  std::size_t count_{};
};

class Session {
 public:
  // The first instructions after a reset.
  static constexpr std::size_t reset_bytes = 8;
  using ResetCode = std::array<std::uint8_t, reset_bytes>;

  // The memory that may be loaded, and its address for the processor. `entry` is that of the
  // program which is there, nothing where there is none that may be started. `way_back` are
  // instructions that lead into the loader: they stand at the start of the memory until a program
  // is whole.
  Session(std::span<std::uint8_t> memory, std::uint32_t address, std::optional<std::uint32_t> entry,
          const ResetCode& way_back)
      : memory_(memory), address_(address), entry_(entry), way_back_(way_back) {}

  Answer handle(const Frame& frame);
  static Answer refuse(Refusal reason);

  // Of a whole program: the one that was there until `begin`, the new one from `start` on.
  std::optional<std::uint32_t> entry() const { return entry_; }
  // A host has had its program checked and requests its start.
  bool start_wanted() const { return start_wanted_; }

 private:
  Answer identify() const;
  Answer begin(std::span<const std::uint8_t> payload);
  Answer take_block(std::span<const std::uint8_t> payload);
  Answer start();
  Answer accept(Kind kind) const;
  void put(std::size_t place, std::uint8_t byte);
  void put_reset_code(const ResetCode& code);
  std::uint32_t checksum() const;

  struct Load {
    std::uint32_t place{};  // in memory_
    std::uint32_t bytes{};
    std::uint32_t checksum{};
    std::uint32_t entry{};
    std::uint32_t received{};
  };

  std::span<std::uint8_t> memory_;
  std::uint32_t address_;
  std::optional<std::uint32_t> entry_;
  ResetCode way_back_;
  ResetCode held_{};  // what the program wants there
  std::optional<Load> load_;
  bool start_wanted_{};
};

}  // namespace boot_loader
