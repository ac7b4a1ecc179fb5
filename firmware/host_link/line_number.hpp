// SPDX-License-Identifier: Apache-2.0
// The line numbers that frame a line and that M110 sets.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace host_link {

// A signed number of at most 32 bits at the start of `text`, which is then moved behind it; empty,
// and `text` unchanged, if there is none or it does not fit.
std::optional<std::int32_t> take_line_number(std::string_view& text);

// G, M or T and a digit: not the remnant of a torn line.
bool looks_like_command(std::string_view text);

// Whether a line's text (without its own number) is an M110.
bool sets_numbering(std::string_view text);

// The N of an M110's text, if it has one: M110 N0.
std::optional<std::int32_t> number_set_by(std::string_view text);

}  // namespace host_link
