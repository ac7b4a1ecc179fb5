// SPDX-License-Identifier: Apache-2.0
// One G-code command as a value: letter, code, parameters as fixed-point numbers, or a text.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace gcode {

// Parameters other than positions are millionths of the unit written in the line.
inline constexpr std::uint32_t millionths_per_unit = 1'000'000;
inline constexpr std::uint32_t billionths_per_unit = 1'000'000'000;

// A number as it is written: magnitude = whole + billionths / 1'000'000'000. Kept in two 32-bit
// halves, so that neither reading nor using it costs a 64-bit division.
struct Number {
  std::uint32_t whole;
  std::uint32_t billionths;  // 0 .. 999'999'999
  bool negative;
};

class Command {
 public:
  char letter{};  // 'G', 'M' or 'T'
  std::uint16_t code{};  // 1 in G1
  std::uint8_t subcode{};  // 2 in G38.2, 0 where none is written
  bool in_machine_coordinates{};  // G53 stood before it
  // Of M117, M118, M23 ..., or between quotes: a part of the parsed line, which must outlive it.
  std::string_view text{};

  // Empty again, as at first.
  void clear() {
    letter = {};
    code = {};
    subcode = {};
    text = {};
    in_machine_coordinates = {};
    present_ = valued_ = negative_ = 0;
  }

  bool is(char wanted_letter, std::uint16_t wanted_code) const {
    return letter == wanted_letter && code == wanted_code;
  }

  // Parameters are looked up by their capital letter, whatever case the line has.
  bool has(char parameter) const { return (present_ & bit(parameter)) != 0; }
  bool has_number(char parameter) const { return (valued_ & bit(parameter)) != 0; }
  bool has_parameters() const { return present_ != 0; }
  // Letters as a set, a bit for each, for the next two.
  static constexpr std::uint32_t bit(char parameter) {
    return parameter >= 'A' && parameter <= 'Z' ? std::uint32_t{1} << index(parameter) : 0;
  }
  static consteval std::uint32_t set_of(std::string_view letters_of_set) {
    std::uint32_t set = 0;
    for (const char parameter : letters_of_set) set |= bit(parameter);
    return set;
  }
  bool has_any(std::uint32_t set) const { return (present_ & set) != 0; }
  bool has_besides(std::uint32_t set) const { return (present_ & ~set) != 0; }

  // The number as written; empty if the parameter is absent or a flag without a number (G28 X).
  std::optional<Number> number(char parameter) const {
    if ((valued_ & bit(parameter)) == 0) return std::nullopt;
    const Magnitude& magnitude = magnitudes_[index(parameter)];
    return Number{magnitude.whole, magnitude.billionths, (negative_ & bit(parameter)) != 0};
  }

  // In millionths, halves away from 0; empty as for number(). Within +-4'294'967'296'000'000.
  std::optional<std::int64_t> value(char parameter) const {
    if ((valued_ & bit(parameter)) == 0) return std::nullopt;
    constexpr std::uint32_t per_millionth = billionths_per_unit / millionths_per_unit;
    const Magnitude& magnitude = magnitudes_[index(parameter)];
    const std::uint32_t millionths = (magnitude.billionths + per_millionth / 2) / per_millionth;
    return with_sign(
        parameter, static_cast<std::int64_t>(std::uint64_t{magnitude.whole} * millionths_per_unit +
                                             millionths));
  }

  // The whole part, cut towards zero as Marlin reads an integer parameter; empty as for value().
  std::optional<std::int64_t> integer(char parameter) const {
    if ((valued_ & bit(parameter)) == 0) return std::nullopt;
    return with_sign(parameter, std::int64_t{magnitudes_[index(parameter)].whole});
  }

  void set_flag(char parameter) { present_ |= bit(parameter); }
  void set(char parameter, Number number) {
    present_ |= bit(parameter);
    valued_ |= bit(parameter);
    negative_ |= number.negative ? bit(parameter) : 0;
    magnitudes_[index(parameter)] = {number.whole, number.billionths};
  }

 private:
  static constexpr std::size_t letter_count = 26;
  static constexpr std::size_t index(char parameter) {
    return static_cast<std::size_t>(parameter - 'A');
  }

  std::int64_t with_sign(char parameter, std::int64_t magnitude) const {
    return (negative_ & bit(parameter)) != 0 ? -magnitude : magnitude;
  }

  struct Magnitude {
    std::uint32_t whole;
    std::uint32_t billionths;
  };

  std::uint32_t present_{};
  std::uint32_t valued_{};
  std::uint32_t negative_{};
  std::array<Magnitude, letter_count> magnitudes_{};
};

}  // namespace gcode
