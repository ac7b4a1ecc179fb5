// SPDX-License-Identifier: Apache-2.0
// Builds one reply line from texts, integers and fixed-point decimals, without printf or heap.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace host_link {

class TextLine {
 public:
  static constexpr std::size_t capacity = 192;

  TextLine& text(std::string_view part);
  TextLine& character(char c);
  TextLine& integer(std::int64_t value);
  // `value` counts 10^-digits; written with `places` <= digits decimals, rounded half away from
  // zero: decimal(205'104, 3, 2) gives 205.10. Never writes -0.00.
  TextLine& decimal(std::int64_t value, unsigned digits, unsigned places);

  std::string_view view() const { return {buffer_.data(), length_}; }
  // False after something did not fit; it is then missing from view() from there on.
  bool complete() const { return complete_; }
  void clear();

 private:
  TextLine& digits(std::uint64_t value, unsigned places);

  std::array<char, capacity> buffer_;
  std::size_t length_{};
  bool complete_{true};
};

}  // namespace host_link
