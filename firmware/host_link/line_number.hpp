// SPDX-License-Identifier: Apache-2.0
// The line numbers that frame a line and that M110 sets.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace host_link {

// Counted modulo 2^32: no host reaches the end, and -1, from which printcore counts, needs no sign.
using LineNumber = std::uint32_t;
inline constexpr LineNumber before_first = 0xffff'ffff;

// As a host writes it: -1, 0 .. 4294967294.
constexpr std::int64_t written(LineNumber number) {
  return number == before_first ? -1 : std::int64_t{number};
}

// A number of -2^31 .. 2^32 - 1 at the start of `text`, which is then moved after it; empty, and
// `text` unchanged, if there is none or it does not fit.
std::optional<LineNumber> take_line_number(std::string_view& text);

// FNV-1a (Fowler, Noll, Vo), 32 bits: shows whether a repeated number brings the same text.
std::uint32_t fingerprint_of(std::string_view text);

// G, M or T and a digit: not the remnant of a torn line.
bool looks_like_command(std::string_view text);

// Whether a line's text (without its own number) is an M110. M110.1 is another command, as for the
// parser and for hosts, which keep only M110 itself back.
inline constexpr std::uint32_t numbering_code = 110;
bool sets_numbering(std::string_view text);

// The N behind an M110, if it has one: M110 N0.
std::optional<LineNumber> number_set_by(std::string_view arguments);

}  // namespace host_link
