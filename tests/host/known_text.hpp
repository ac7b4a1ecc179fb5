// SPDX-License-Identifier: Apache-2.0
// Uploads that show by themselves whether they are whole.
#pragma once

#include <charconv>
#include <random>
#include <string>
#include <string_view>

namespace host_test {

// Of up to 80 KB; it begins with its seed.
inline std::string known_text(unsigned seed) {
  std::mt19937 random(seed);
  std::string text = std::to_string(seed) + "\n";
  const std::size_t size = 1 + random() % 20'000 * (1 + random() % 4);
  while (text.size() < size) text += std::to_string(random()) + "\n";
  return text;
}

inline bool is_known_text(std::string_view text) {
  unsigned seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  return error == std::errc{} && end != text.data() + text.size() && known_text(seed) == text;
}

}  // namespace host_test
