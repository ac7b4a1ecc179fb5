// SPDX-License-Identifier: Apache-2.0
// Speeds, input shaping and linear advance: F, M203, M205, M207, M208, M220, M593, M900 and M572.
#include <algorithm>

#include "sim/report/gcode_path.hpp"

namespace report {

namespace {

// Between the first quotes.
std::string_view quoted(std::string_view command) {
  const std::size_t from = command.find('"');
  if (from == std::string_view::npos) return {};
  const std::size_t to = command.find('"', from + 1);
  return command.substr(from + 1, to == std::string_view::npos ? to : to - from - 1);
}

// In units of 1 / per_unit, halves away from zero.
std::int64_t rounded(std::int64_t value, std::int64_t per_unit) {
  const std::int64_t one = billionths / per_unit;
  return (value + one / 2) / one;
}

}  // namespace

// F of a line, M207 and M208; M203 E; M205 S and T: the slowest speeds; M220 S, of which B keeps
// what holds, and R brings it back.
void GcodePath::read_speed(const GcodeWords& words) {
  if (words.is('M', 220)) {
    const std::int64_t before = speed_percent_;
    if (words.has('R')) speed_percent_ = kept_speed_percent_;
    if (const auto percent = words.value('S')) speed_percent_ = *percent / billionths;
    if (words.has('B')) kept_speed_percent_ = before;
  } else if (words.is('M', 205)) {
    for (std::size_t i = 0; i < least_mm_s_.size(); ++i) {
      if (const auto least = length(words, i == 0 ? 'S' : 'T')) {
        least_mm_s_[i] = millimeters(*least);
      }
    }
  } else if (words.is('M', 203)) {
    if (const auto most = length(words, 'E')) extruder_mm_s_ = millimeters(*most);
  } else if (const auto feed = length(words, 'F')) {
    constexpr double seconds_per_minute = 60;
    double& speed = words.is('M', 207)   ? retract_mm_s_
                    : words.is('M', 208) ? recover_mm_s_
                                         : feed_mm_s_;
    speed = millimeters(*feed) / seconds_per_minute;
  }
}

// E, and what goes along with it.
void GcodePath::hold_back(Move& move) const {
  double& most = move.extruder_mm_s;
  if (extruder_mm_s_ > 0) most = most > 0 ? std::min(most, extruder_mm_s_) : extruder_mm_s_;
}

// F0 is off, and F alone a ZV shaper; S is D.
void GcodePath::read_shaping(const GcodeWords& words, std::string_view command) {
  if (words.is('M', 501) || words.is('M', 502)) shaping_ = *given_.shaping;
  if (words.is('M', 900) || words.is('M', 572)) {
    const auto seconds = words.value(words.is('M', 572) ? 'S' : 'K');
    if (seconds) shaping_.advance_us = *seconds / (billionths / 1'000'000);
  }
  if (!words.is('M', 593)) return;
  const bool all = !words.has('X') && !words.has('Y');
  for (std::size_t i = 0; i < shaping_.shapers.size(); ++i) {
    if (!all && !words.has(i == 0 ? 'X' : 'Y')) continue;
    ShaperSetting& shaper = shaping_.shapers[i];
    const auto hertz = words.value('F');
    const auto damping = words.has('D') ? words.value('D') : words.value('S');
    if (hertz) shaper.millihertz = rounded(*hertz, 1000);
    if (damping) shaper.damping = rounded(*damping, 10'000);
    if (words.has('P')) {
      shaper.kind = shaper_named(quoted(command)).value_or(shaper.kind);
    } else if (hertz && shaper.kind == ShaperKind::none) {
      shaper.kind = ShaperKind::zv;
    }
    if (hertz && *hertz == 0) shaper.kind = ShaperKind::none;
  }
}

}  // namespace report
