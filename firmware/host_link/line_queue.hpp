// SPDX-License-Identifier: Apache-2.0
// The accepted lines that wait to be executed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "host_link/line_receiver.hpp"

namespace host_link {

struct AcceptedLine {
  std::string_view text;  // without line number and checksum; comments are still in it
  std::optional<LineNumber> number;  // empty for a line sent without one
  bool emergency{};  // has been acted on when it was received: only its ok is due
};

class LineQueue {
 public:
  // Cura keeps 4 lines in flight, printcore 2.
  static constexpr std::size_t capacity = 8;

  std::size_t size() const { return size_; }
  std::size_t room() const { return capacity - size_; }

  // Needs room() != 0.
  void put(const ReceivedLine& line, bool emergency);
  // Needs size() != 0. The text is valid until drop().
  AcceptedLine front() const;
  void drop();

  // The numbered lines, if each has the number after the one before it, and none has been acted on
  // or sets the numbering; otherwise 0.
  std::size_t numbered_in_sequence() const;
  // They will not be executed: each is to be dropped when it reaches the front.
  void withdraw_numbered();
  bool front_is_withdrawn() const { return size_ != 0 && slots_[first_].withdrawn; }
  // Those that are not withdrawn.
  std::size_t waiting() const { return size_ - withdrawn_; }

  // Line n of all that were ever put, counted from 0, lies in slot n % capacity. The layout is a
  // contract with the simulation, which writes down what was accepted.
  struct Slot {
    std::array<char, max_line_length> text;
    LineNumber number;
    std::uint8_t length;
    bool numbered;
    bool emergency;
    bool withdrawn;
  };
  static_assert(max_line_length <= 255, "length of a slot fits its type");
  static_assert(sizeof(Slot) == 136 && offsetof(Slot, number) == 128 &&
                offsetof(Slot, length) == 132 && offsetof(Slot, numbered) == 133);
  const Slot* slots() const { return slots_.data(); }

 private:
  std::array<Slot, capacity> slots_{};
  std::size_t first_{};
  std::size_t size_{};
  std::size_t withdrawn_{};  // of these
  std::uint8_t set_numbering_{};  // a bit for each slot
  static_assert(capacity <= 8);
};

}  // namespace host_link
