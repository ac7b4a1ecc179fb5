// SPDX-License-Identifier: Apache-2.0
// Escaping and the choice of units.
#include "sim/report/markup.hpp"

#include <cmath>

namespace report {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char character : text) {
    switch (character) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += character;
    }
  }
  return result;
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, "\u202f");
  return digits;
}

std::string duration(double seconds) {
  const auto tenths = static_cast<std::uint64_t>(std::llround(10 * seconds));
  if (tenths < 600) return fmt::format("{}.{} s", tenths / 10, tenths % 10);
  const auto whole = static_cast<std::uint64_t>(std::llround(seconds));
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  const std::uint64_t minutes = (whole + 30) / 60;
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

std::string length_text(double mm) {
  // The limits are those of the rounding, so that 1000 µm is never written.
  const double size = std::abs(mm);
  if (size < 0.09995) return fmt::format("{:.1f} µm", 1000 * mm);
  if (size < 0.9995) return fmt::format("{:.0f} µm", 1000 * mm);
  if (size < 9.9995) return fmt::format("{:.3f} mm", mm);
  if (size < 999.95) return fmt::format("{:.2f} mm", mm);
  return fmt::format("{:.2f} m", mm / 1000);
}

std::string counted(std::uint64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(number), noun, number == 1 ? "" : "s");
}

}  // namespace report
