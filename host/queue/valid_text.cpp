// SPDX-License-Identifier: Apache-2.0
// The forms of UTF-8, as Unicode's table 3-7 has them.
#include "host/queue/valid_text.hpp"

#include <cstddef>

namespace queue {

namespace {

// The length of the character that the text begins with; 0 where it begins with none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const auto is_in = [](unsigned value, unsigned low, unsigned high) {
    return value >= low && value <= high;
  };
  const auto continues = [&](std::size_t i) { return is_in(byte(i), 0x80, 0xbf); };
  const unsigned first = byte(0);
  if (is_in(first, 0x01, 0x7f)) return 1;
  if (is_in(first, 0xc2, 0xdf)) return continues(1) ? 2 : 0;
  if (is_in(first, 0xe0, 0xef)) {
    // Neither longer than it needs to be nor a surrogate.
    const bool fits = is_in(byte(1), first == 0xe0 ? 0xa0 : 0x80, first == 0xed ? 0x9f : 0xbf);
    return fits && continues(2) ? 3 : 0;
  }
  if (is_in(first, 0xf0, 0xf4)) {
    const bool fits = is_in(byte(1), first == 0xf0 ? 0x90 : 0x80, first == 0xf4 ? 0x8f : 0xbf);
    return fits && continues(2) && continues(3) ? 4 : 0;
  }
  return 0;
}

}  // namespace

std::string valid_text(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    valid += length == 0 ? std::string_view("\xef\xbf\xbd") : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return valid;
}

}  // namespace queue
