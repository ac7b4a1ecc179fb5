// SPDX-License-Identifier: Apache-2.0
// Words with the digits of slicers, exact places behind them.
#include "shaped_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tests {

namespace {

constexpr double units_per_mm = 1e5, units_per_inch_digit = 254;  // of 0.0001 inch
constexpr std::string_view letters = "XYZE";

}  // namespace

Axes ProgramWriter::place_mm() const {
  Axes place{};
  for (std::size_t i = 0; i < 4; ++i) place[i] = static_cast<double>(place_[i]) / units_per_mm;
  return place;
}

// Nearest, halves away from zero.
Axes ProgramWriter::steps() const {
  Axes steps{};
  for (std::size_t i = 0; i < 4; ++i) {
    steps[i] = static_cast<double>(
        ShapedPrinter::start[i] +
        std::llround(static_cast<double>(place_[i]) * limits_.steps_per_mm[i] / units_per_mm));
  }
  return steps;
}

ProgramWriter::Units ProgramWriter::rounded(double mm) const {
  const double digit = inches_ ? units_per_inch_digit : 1;
  return std::llround(mm * units_per_mm / digit) * static_cast<Units>(digit);
}

std::string ProgramWriter::length_word(char letter, Units value) const {
  return inches_ ? fmt::format(" {}{:.4f}", letter, static_cast<double>(value) / 254 / 1e4)
                 : fmt::format(" {}{:.5f}", letter, static_cast<double>(value) / units_per_mm);
}

std::string ProgramWriter::word(char letter, std::size_t axis, double by_mm) {
  const Units before = named_[axis];
  const bool relative = axis == 3 ? relative_extruder_ : relative_;
  const Units value =
      relative ? rounded(by_mm) : rounded(static_cast<double>(before) / units_per_mm + by_mm);
  const Units by = relative ? value : value - before;
  named_[axis] += by;
  place_[axis] += by;
  return length_word(letter, value);
}

// In whole 0.01 mm/s, exact in mm/min and in inches/min to what no judge sees.
void ProgramWriter::add_feed(std::string& text) {
  if (feed_mm_s_ == written_feed_) return;
  written_feed_ = feed_mm_s_;
  const double per_minute = feed_mm_s_ * 60 / (inches_ ? 25.4 : 1);
  text += fmt::format(" F{:.6f}", std::ceil(per_minute * 1e6) / 1e6);
}

void ProgramWriter::line(double x, double y, double z, double e, int always) {
  const Axes from_mm = place_mm(), from = steps();
  const std::array<double, 4> by{x, y, z, e};
  std::string text = e > 0 ? "G1" : "G0";
  for (std::size_t i = 0; i < 4; ++i) {
    if (by[i] != 0 || static_cast<int>(i) == always) text += word(letters[i], i, by[i]);
  }
  add_feed(text);
  Command command{.text = text, .is_move = true};
  if (text.find_first_of(letters) == std::string::npos) command.is_move = false;
  const Axes to_mm = place_mm();
  Way way{.from = from, .to = steps(), .speed_mm_s = speed(), .pause_s = -1};
  way.length_mm = std::hypot(to_mm[0] - from_mm[0], to_mm[1] - from_mm[1], to_mm[2] - from_mm[2]);
  if (way.length_mm == 0) way.length_mm = std::abs(to_mm[3] - from_mm[3]);
  way.prints = to_mm[3] > from_mm[3] && (to_mm[0] != from_mm[0] || to_mm[1] != from_mm[1]);
  command.ways.push_back(way);
  commands_.push_back(command);
}

// I and J are the same in all modes; the end may be off the circle by what a digit holds.
void ProgramWriter::arc(double i, double j, double angle, double z, double e) {
  const Axes from_mm = place_mm(), from = steps();
  const Units offset_x = rounded(i), offset_y = rounded(j);
  const std::array<double, 2> centre{from_mm[0] + static_cast<double>(offset_x) / units_per_mm,
                                     from_mm[1] + static_cast<double>(offset_y) / units_per_mm};
  const double first = std::atan2(from_mm[1] - centre[1], from_mm[0] - centre[0]);
  const double radius = std::hypot(from_mm[0] - centre[0], from_mm[1] - centre[1]);
  const bool full = std::abs(angle) > 6.28;
  std::string text = angle < 0 ? "G2" : "G3";
  if (!full) {
    text += word('X', 0, centre[0] + radius * std::cos(first + angle) - from_mm[0]);
    text += word('Y', 1, centre[1] + radius * std::sin(first + angle) - from_mm[1]);
  }
  if (z != 0) text += word('Z', 2, z);
  if (e != 0) text += word('E', 3, e);
  text += length_word('I', offset_x) + length_word('J', offset_y);
  add_feed(text);
  const Axes to_mm = place_mm(), to = steps();
  const double sweep = full ? std::copysign(2 * std::numbers::pi, angle) : angle;
  const double end_radius = std::hypot(to_mm[0] - centre[0], to_mm[1] - centre[1]);
  const double length = std::hypot(std::abs(sweep) * radius, to_mm[2] - from_mm[2]);
  constexpr double chord_mm = 0.0005;  // deviation
  const int count = std::max(
      4, static_cast<int>(std::ceil(std::abs(sweep) * radius / std::sqrt(8 * radius * chord_mm))));
  Command command{.text = text, .is_move = true};
  Axes before = from;
  for (int n = 1; n <= count; ++n) {
    const double part = static_cast<double>(n) / count;
    const double r = radius + part * (end_radius - radius);
    const std::array<double, 2> at{centre[0] + r * std::cos(first + part * sweep),
                                   centre[1] + r * std::sin(first + part * sweep)};
    Axes next = to;
    if (n < count) {
      for (std::size_t a = 0; a < 4; ++a) {
        next[a] =
            a < 2 ? static_cast<double>(ShapedPrinter::start[a]) + at[a] * limits_.steps_per_mm[a]
                  : from[a] + part * (to[a] - from[a]);
      }
    }
    Way way{.from = before,
            .to = next,
            .length_mm = length / count,
            .speed_mm_s = speed(),
            .prints = e > 0,
            .pause_s = -1};
    way.speed_mm_s =
        std::min(way.speed_mm_s, std::sqrt(limits_.acceleration_mm_s2 * std::max(radius, 0.01)));
    command.ways.push_back(way);
    before = next;
  }
  commands_.push_back(command);
}

// 3 mm unless M207 says otherwise, which no program here does.
void ProgramWriter::retract_by_code() {
  if (retracted_) return;
  retracted_ = true;
  const Axes from = steps();
  place_[3] -= static_cast<Units>(3 * units_per_mm);
  Way way{.from = from, .to = steps(), .length_mm = 3, .speed_mm_s = 30, .pause_s = -1};
  commands_.push_back({.text = "G10", .ways = {way}, .is_move = true});
}

void ProgramWriter::recover_by_code() {
  if (!retracted_) return;
  retracted_ = false;
  const Axes from = steps();
  place_[3] += static_cast<Units>(3 * units_per_mm);
  Way way{.from = from, .to = steps(), .length_mm = 3, .speed_mm_s = 30, .pause_s = -1};
  commands_.push_back({.text = "G11", .ways = {way}, .is_move = true});
}

void ProgramWriter::dwell(double seconds) {
  commands_.push_back({.text = fmt::format("G4 P{:.0f}", seconds * 1000), .pause_s = seconds});
}

void ProgramWriter::relative(bool relative) {
  relative_ = relative_extruder_ = relative;
  text(relative ? "G91" : "G90");
}

void ProgramWriter::relative_extruder(bool relative) {
  relative_extruder_ = relative;
  text(relative ? "M83" : "M82");
}

void ProgramWriter::inches(bool inches) {
  inches_ = inches;
  text(inches ? "G20" : "G21");
}

void ProgramWriter::name_place(std::size_t axis, double mm) {
  named_[axis] = rounded(mm);
  text("G92" + length_word(letters[axis], named_[axis]));
}

void ProgramWriter::percent(int percent) {
  percent_ = percent;
  text(fmt::format("M220 S{}", percent));
}

}  // namespace tests
