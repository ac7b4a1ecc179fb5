// SPDX-License-Identifier: Apache-2.0
// Reply lines on their way to the uart: a ring that accepts a line as a whole or not at all.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

namespace host_link {

class TransmitQueue {
 public:
  static constexpr std::size_t capacity = 512;  // bytes

  std::size_t room() const { return capacity - size_; }
  bool empty() const { return size_ == 0; }

  static constexpr std::size_t most_parts = 3;
  // Appends the parts, at most so many, as one line, with its line end; false, and nothing done,
  // unless `spare` bytes remain free afterwards. Bytes outside 0x20 .. 0x7e become '?': a host that
  // reads UTF-8 survives.
  bool put_line(std::initializer_list<std::string_view> parts, std::size_t spare = 0);

  // The oldest bytes, as many as lie in one piece.
  std::span<const char> front() const;
  void drop(std::size_t count);

 private:
  std::array<char, capacity> bytes_{};
  std::size_t first_{};
  std::size_t size_{};
};

}  // namespace host_link
