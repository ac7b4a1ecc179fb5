// SPDX-License-Identifier: Apache-2.0
// G28 homes; M18, M84 and M112 switch the motors off.
#include "host/feeder/homed_axes.hpp"

#include <cctype>

namespace feeder {

void HomedAxes::sent(std::string_view line) {
  std::string text;
  for (const char c : line.substr(0, line.find_first_of(";("))) {
    if (c != ' ') text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  const auto is_code = [&text](std::string_view code) {
    const bool goes_on =
        text.size() > code.size() && text[code.size()] >= '0' && text[code.size()] <= '9';
    return text.starts_with(code) && !goes_on && text.substr(code.size(), 1) != ".";
  };
  if (is_code("M84") || is_code("M18") || is_code("M112")) return forget();
  if (!is_code("G28")) return;
  const bool names_any = text.find_first_of("XYZ", 3) != std::string::npos;
  std::string homed;
  for (const char axis : std::string_view("xyz")) {
    const bool was = axes_.find(axis) != std::string::npos;
    const bool is_named = text.find(static_cast<char>(std::toupper(axis)), 3) != std::string::npos;
    if (was || is_named || !names_any) homed += axis;
  }
  axes_ = homed;
}

}  // namespace feeder
