// SPDX-License-Identifier: Apache-2.0
// Lines as they go over the serial line: number and checksum, and what replies say.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace feeder {

// `N<number> <text>*<XOR of all bytes before the star>` and the line end.
std::string framed(std::int64_t number, std::string_view text);

// The number in a `Resend: N` or `rs N`; nothing where the line is no such request.
std::optional<std::int64_t> resend_in(std::string_view reply);

// In degrees Celsius; a target of 0 is off. Powers are parts of all, 0 to 1.
struct Temperatures {
  std::optional<double> hotend, hotend_target, hotend_power, bed, bed_target, bed_power;
};
// Takes what a reply says of them (`T:20.00 /0.00 B:20.00 /0.00 @:0 B@:0`, powers of 127); false
// where it says nothing.
bool read_temperatures(std::string_view reply, Temperatures& temperatures);

// Where the motors are: what was asked for, in mm, and the steps counted of X, Y and Z.
struct Position {
  std::array<double, 4> mm{};  // X, Y, Z, E
  std::array<std::int64_t, 3> steps{};
  bool operator==(const Position&) const = default;
};
// Of a report as `X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0`; nothing where it is none.
std::optional<Position> position_in(std::string_view reply);

// An `Error:` or `!!` after which the printer does not go on, not one that a Resend follows.
bool is_fatal(std::string_view reply);

}  // namespace feeder
