// SPDX-License-Identifier: Apache-2.0
// Building blocks of the page: escaped text, and numbers as a person reads them.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

namespace report {

using Page = fmt::memory_buffer;

template <class... Arguments>
void add(Page& page, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(page), text, std::forward<Arguments>(arguments)...);
}

std::string escaped(std::string_view text);
// 12 345, with narrow spaces that do not break.
std::string grouped(std::uint64_t number);
// 4.5 s, 2 min 39 s, 1 h 04 min.
std::string duration(double seconds);
// In µm, mm or m, with three to five digits.
std::string length_text(double mm);
// 0 of "point": "0 points", 1: "1 point".
std::string counted(std::uint64_t number, std::string_view noun);

}  // namespace report
