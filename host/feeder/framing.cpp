// SPDX-License-Identifier: Apache-2.0
// Text in, text out.
#include "host/feeder/framing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace feeder {

namespace {

constexpr double full_power = 127;
constexpr double most_steps = 4e9;

std::optional<double> number_after(std::string_view text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos) return std::nullopt;
  text.remove_prefix(at + mark.size());
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  return value;
}

// The part of a report that begins with this heater's letter.
std::string_view part_of(std::string_view reply, std::string_view mark) {
  for (std::size_t at = reply.find(mark); at != std::string_view::npos;
       at = reply.find(mark, at + 1)) {
    if (at == 0 || reply[at - 1] == ' ') {
      std::string_view part = reply.substr(at + mark.size());
      part = part.substr(0, part.find(':'));  // of the next heater
      return part;
    }
  }
  return {};
}

}  // namespace

std::string framed(std::int64_t number, std::string_view text) {
  std::string line = "N" + std::to_string(number) + " " + std::string(text);
  unsigned checksum = 0;
  for (const char c : line) checksum ^= static_cast<unsigned char>(c);
  return line + "*" + std::to_string(checksum) + "\n";
}

std::optional<std::int64_t> resend_in(std::string_view reply) {
  constexpr std::array<std::string_view, 3> words{"Resend:", "resend:", "rs "};
  for (const std::string_view word : words) {
    if (!reply.starts_with(word)) continue;
    reply.remove_prefix(word.size());
    reply.remove_prefix(std::min(reply.find_first_not_of(" N:"), reply.size()));
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(reply.data(), reply.data() + reply.size(), number);
    if (error != std::errc{}) return std::nullopt;
    return number;
  }
  return std::nullopt;
}

bool read_temperatures(std::string_view reply, Temperatures& temperatures) {
  const auto power = [reply](std::string_view mark) -> std::optional<double> {
    const auto value = number_after(part_of(reply, mark), "");
    if (!value) return std::nullopt;
    return std::clamp(*value / full_power, 0.0, 1.0);
  };
  const std::string_view hotend = part_of(reply, "T:"), bed = part_of(reply, "B:");
  const auto hotend_now = number_after(hotend, ""), bed_now = number_after(bed, "");
  if (!hotend_now && !bed_now) return false;
  if (hotend_now) {
    temperatures.hotend = hotend_now;
    temperatures.hotend_target = number_after(hotend, "/");
    temperatures.hotend_power = power("@:");
  }
  if (bed_now) {
    temperatures.bed = bed_now;
    temperatures.bed_target = number_after(bed, "/");
    temperatures.bed_power = power("B@:");
  }
  return true;
}

std::optional<Position> position_in(std::string_view reply) {
  constexpr std::array<std::string_view, 4> axes{"X:", "Y:", "Z:", "E:"};
  const std::size_t count = reply.find(" Count ");
  if (!reply.starts_with(axes[0]) || count == std::string_view::npos) return std::nullopt;
  const std::string_view asked = reply.substr(0, count), counted = reply.substr(count);
  Position position;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const auto mm = number_after(asked, axes[axis]);
    if (!mm) return std::nullopt;
    position.mm[axis] = *mm;
    if (axis >= position.steps.size()) continue;
    const auto steps = number_after(counted, axes[axis]);
    if (!steps || std::abs(*steps) > most_steps) return std::nullopt;
    position.steps[axis] = std::llround(*steps);
  }
  return position;
}

bool is_fatal(std::string_view reply) {
  if (reply.starts_with("!!")) return true;
  if (!reply.starts_with("Error:")) return false;
  constexpr std::array<std::string_view, 4> of_lines{"checksum", "Checksum", "Line Number",
                                                     "Last Line"};
  return std::ranges::none_of(
      of_lines, [reply](std::string_view word) { return reply.find(word) != reply.npos; });
}

}  // namespace feeder
