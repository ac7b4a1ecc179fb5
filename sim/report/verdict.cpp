// SPDX-License-Identifier: Apache-2.0
// The criteria by which a print is bad.
#include "sim/report/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace report {

namespace {

// A line between rounded ends may lie up to 1.41 steps off the exact one (firmware/motion).
constexpr double most_steps_off_line = 2.0;
// From the target while it is held: fans and cold filament cost a few degrees.
constexpr double widest_band_c = 10.0;

const char* plural(std::uint64_t count) { return count == 1 ? "" : "s"; }

// "X 3, E 27"
std::string by_axis(const std::array<std::uint64_t, motor_count>& counts) {
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", axis_titles[i], counts[i]);
    }
  }
  return text;
}

// "X, E"
std::string names_of(const std::array<bool, motor_count>& axes) {
  std::string text;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i]) text += fmt::format("{}{}", text.empty() ? "" : ", ", axis_titles[i]);
  }
  return text;
}

template <class Count>
std::string by_axis(const Results& results, Count count) {
  std::array<std::uint64_t, motor_count> counts{};
  std::ranges::transform(results.axes, counts.begin(), count);
  return by_axis(counts);
}

}  // namespace

void judge(Results& results) {
  Findings& findings = results.findings;
  std::vector<std::string>& problems = findings.problems;
  problems.clear();
  if (results.outcome == Outcome::faulted) {
    problems.push_back(results.fault.empty() ? "the print faulted" : results.fault);
  }
  if (const std::uint64_t count = findings.refused_count; count > 0) {
    problems.push_back(fmt::format("{} line{} that should move or heat refused by the chip", count,
                                   plural(count)));
  }
  if (const std::uint64_t count = results.other_programs; count > 0) {
    problems.push_back(
        fmt::format("another program took the firmware's place ({} time{}): which "
                    "lines it took is not known",
                    count, plural(count)));
  }
  if (const std::uint64_t count = results.gaps; count > 0) {
    problems.push_back(
        fmt::format("lines that the firmware took are not known ({} gap{} in its counts)", count,
                    plural(count)));
  }
  // Where a print was stopped in mid-move, its target is not known.
  const bool stopped = results.outcome == Outcome::stopped;
  if (const std::uint64_t count = results.points_missed; count > 0 && !stopped) {
    problems.push_back(fmt::format("{} of {} points missed ({})", count,
                                   count + results.points_reached,
                                   by_axis(findings.missed_by_axis)));
  }
  if (results.max_deviation_steps > most_steps_off_line) {
    problems.push_back(
        fmt::format("the path leaves its lines by up to {:.3f} mm", results.max_deviation_mm));
  }
  const std::string unasked =
      by_axis(results, [](const AxisResult& axis) { return axis.unasked_steps; });
  if (const std::uint64_t count = findings.lines_apart; count > 0) {
    problems.push_back(fmt::format("{} line{} on which Z or E does not go along with X and Y",
                                   count, plural(count)));
  }
  if (findings.max_height_error_mm > 0) {
    problems.push_back(fmt::format("Z leaves the height above the mesh by up to {:.3f} mm",
                                   findings.max_height_error_mm));
  }
  if (const std::string axes = names_of(findings.homed_elsewhere); !axes.empty()) {
    problems.push_back(fmt::format("homing ended away from the end stop: {}", axes));
  }
  const std::string moved = names_of(findings.moved_after_end);
  if (!moved.empty() && results.outcome == Outcome::completed) {
    problems.push_back(fmt::format("axes moved after the last line: {}", moved));
  }
  for (const bool bed : {false, true}) {
    const TemperatureResult& heater = bed ? results.bed : results.hotend;
    if (heater.band_c > widest_band_c) {
      problems.push_back(fmt::format("the {} was {:.1f} °C off its target after the wait for it",
                                     bed ? "bed" : "hotend", heater.band_c));
    }
  }
  if (!unasked.empty() && !stopped) {
    problems.push_back(fmt::format("steps that no line asks for: {}", unasked));
  }
  if (const std::uint64_t count = findings.lines_lost; count > 0) {
    problems.push_back(
        fmt::format("{} line{} of the file lost: never carried out", count, plural(count)));
  }
  if (const std::uint64_t count = results.underruns; count > 0) {
    problems.push_back(
        fmt::format("{} underrun{}: the motion stopped abruptly because no line was queued", count,
                    plural(count)));
  }
  const std::string illegal =
      by_axis(results, [](const AxisResult& axis) { return axis.illegal_pulses; });
  if (!illegal.empty()) {
    problems.push_back(fmt::format("pulses that break the driver's times: {}", illegal));
  }
  const std::string lost = by_axis(results, [](const AxisResult& axis) {
    return axis.disabled_pulses + axis.slipped_steps + axis.frame_steps;
  });
  if (!lost.empty()) problems.push_back(fmt::format("steps lost by the motors: {}", lost));
}

}  // namespace report
