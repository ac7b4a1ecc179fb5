// SPDX-License-Identifier: Apache-2.0
// Lines as they go over the serial line: number and checksum, and what replies say.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace feeder {

// `N<number> <text>*<XOR of all bytes before the star>` and the line end.
std::string framed(std::int64_t number, std::string_view text);

// The number in a `Resend: N` or `rs N`; nothing where the line is no such request.
std::optional<std::int64_t> resend_in(std::string_view reply);

// In degrees Celsius; a target of 0 is off.
struct Temperatures {
  std::optional<double> hotend, hotend_target, bed, bed_target;
};
// Takes what a reply says of them (`T:20.00 /0.00 B:20.00 /0.00`); false where it says nothing.
bool read_temperatures(std::string_view reply, Temperatures& temperatures);

// An `Error:` or `!!` after which the printer does not go on, not one that a Resend follows.
bool is_fatal(std::string_view reply);

}  // namespace feeder
