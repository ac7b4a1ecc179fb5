// SPDX-License-Identifier: Apache-2.0
// The codes that disturb no print.
#include "host/feeder/typed_line.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>

namespace feeder {

namespace {

constexpr std::array<std::int64_t, 27> harmless_codes{
    27,  31,  73,  78,  // progress and times
    104, 140,  // targets, without a wait
    105, 113, 114, 115, 117, 118, 119, 154, 155,  // reports and messages
    106, 107,  // fan
    108,  // ends a wait
    201, 203, 204, 205,  // accelerations, speeds, jerk
    220, 221,  // speed, flow
    290,  // baby steps
    300, 503};

}  // namespace

std::string_view without_blanks(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

std::int64_t m_code_of(std::string_view text) {
  text = without_blanks(text);
  if (!text.starts_with('M') && !text.starts_with('m')) return 0;
  text = without_blanks(text.substr(1));
  std::int64_t code = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), code);
  return error == std::errc{} ? code : 0;
}

bool is_harmless(std::string_view text) {
  return std::ranges::contains(harmless_codes, m_code_of(text));
}

}  // namespace feeder
