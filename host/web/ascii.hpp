// SPDX-License-Identifier: Apache-2.0
// Names whose ASCII letters count without their case.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace web {

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

inline std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) { return lower(c); });
  return text;
}

inline bool equal_names(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char one, char other) { return lower(one) == lower(other); });
}

}  // namespace web
