// SPDX-License-Identifier: Apache-2.0
// Searches in short texts. Those of the library have loops without a bound (units/loop_bound.hpp).
#pragma once

#include <cstddef>
#include <string_view>

#include "units/loop_bound.hpp"

namespace units {

// Of a line from the host, without its end; no text that is searched is longer.
inline constexpr std::size_t longest_text = 128;

// The first place of one of `wanted` from `start` on; npos without one.
inline std::size_t find_first_of(std::string_view text, std::string_view wanted,
                                 std::size_t start = 0) {
  LoopBound<longest_text> places;
  for (std::size_t i = start; i < text.size(); ++i) {
    places.next();
    constexpr std::size_t most_wanted = 16;
    LoopBound<most_wanted> characters;
    for (const char c : wanted) {
      characters.next();
      if (text[i] == c) return i;
    }
  }
  return std::string_view::npos;
}

inline std::size_t find(std::string_view text, char wanted, std::size_t start = 0) {
  return find_first_of(text, {&wanted, 1}, start);
}

inline bool starts_with(std::string_view text, std::string_view prefix) {
  if (text.size() < prefix.size()) return false;
  constexpr std::size_t longest_prefix = 16;
  LoopBound<longest_prefix> characters;
  for (std::size_t i = 0; i < prefix.size(); ++i) {
    characters.next();
    if (text[i] != prefix[i]) return false;
  }
  return true;
}

inline bool equal(std::string_view one, std::string_view other) {
  return one.size() == other.size() && starts_with(one, other);
}

}  // namespace units
