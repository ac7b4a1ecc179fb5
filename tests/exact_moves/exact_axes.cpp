// SPDX-License-Identifier: Apache-2.0
// Decimal text to whole parts of a length, and positions as their sums.
#include "tests/exact_moves/exact_axes.hpp"

namespace exact_moves {

namespace {

constexpr std::string_view letters = "XYZE";
constexpr std::int64_t parts_per_billionth_mm = 500;
constexpr std::int64_t parts_per_billionth_inch = 12'700;
constexpr Wide parts_per_meter = Wide{parts_per_billionth_mm} * 1'000'000'000 * 1'000;

// The text after `letter`, which stands after a blank.
std::optional<std::string_view> word(std::string_view line, char letter) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i - 1] != ' ' || line[i] != letter) continue;
    const std::string_view rest = line.substr(i + 1);
    return rest.substr(0, rest.find(' '));
  }
  return std::nullopt;
}

// At most nine decimals.
Wide billionths(std::string_view number) {
  const bool negative = number.starts_with('-');
  Wide value = 0;
  int decimals = 0;
  bool behind_point = false;
  for (const char c : number) {
    if (c == '.') behind_point = true;
    if (c < '0' || c > '9') continue;
    value = value * 10 + (c - '0');
    if (behind_point) ++decimals;
  }
  for (; decimals < 9; ++decimals) value *= 10;
  return negative ? -value : value;
}

}  // namespace

std::optional<Wide> ExactAxes::length(std::string_view line, char letter) const {
  const auto number = word(line, letter);
  if (!number) return std::nullopt;
  return billionths(*number) * (inches_ ? parts_per_billionth_inch : parts_per_billionth_mm);
}

void ExactAxes::take(std::string_view line) {
  const std::string_view code = line.substr(0, line.find(' '));
  if (code == "G0" || code == "G1" || code == "G2" || code == "G3") move(line);
  if (code == "G20") inches_ = true;
  if (code == "G21") inches_ = false;
  if (code == "G90") relative_ = extruder_relative_ = false;
  if (code == "G91") relative_ = extruder_relative_ = true;
  if (code == "M82") extruder_relative_ = false;
  if (code == "M83") extruder_relative_ = true;
  if (code == "M221") {
    flow_percent_ = static_cast<std::int64_t>(billionths(*word(line, 'S')) / 1'000'000'000);
  }
  if (code == "G92") {
    for (std::size_t i = 0; i < axis_count; ++i) {
      if (const auto value = length(line, letters[i])) logical_[i] = *value;
    }
  }
}

void ExactAxes::move(std::string_view line) {
  for (std::size_t i = 0; i < axis_count; ++i) {
    const auto value = length(line, letters[i]);
    if (!value) continue;
    const Wide distance = relative(i) ? *value : *value - logical_[i];
    machine_[i] += i == 3 ? distance * flow_percent_ / 100 : distance;  // no remainder
    logical_[i] += distance;
  }
}

std::array<std::int64_t, axis_count> ExactAxes::steps() const {
  std::array<std::int64_t, axis_count> steps;
  for (std::size_t i = 0; i < axis_count; ++i) {
    const Wide product = machine_[i] * steps_per_meter_[i];
    const Wide size = product < 0 ? -product : product;
    const auto count = static_cast<std::int64_t>((size + parts_per_meter / 2) / parts_per_meter);
    steps[i] = product < 0 ? -count : count;
  }
  return steps;
}

double ExactAxes::logical_mm(std::size_t axis) const {
  return static_cast<double>(logical_[axis]) / (1e9 * parts_per_billionth_mm);
}

}  // namespace exact_moves
