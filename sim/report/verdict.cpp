// SPDX-License-Identifier: Apache-2.0
// The list of what makes a print bad.
#include "sim/report/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace report {

namespace {

// A line between rounded ends may lie up to 1.41 steps off the exact one (firmware/motion).
constexpr double most_steps_off_line = 2.0;

const char* plural(std::uint64_t count) { return count == 1 ? "" : "s"; }

// "X 3, E 27"
std::string by_axis(const std::array<std::uint64_t, 4>& counts) {
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                          static_cast<char>(axis_names[i][0] - 'a' + 'A'), counts[i]);
    }
  }
  return text;
}

template <class Count>
std::string by_axis(const Results& results, Count count) {
  std::array<std::uint64_t, 4> counts{};
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
  if (const std::uint64_t count = results.points_missed; count > 0) {
    problems.push_back(fmt::format("{} of {} points missed ({})", count,
                                   count + results.points_reached,
                                   by_axis(findings.missed_by_axis)));
  }
  const double off_steps = results.max_deviation_mm * results.coarsest_xy_steps_per_mm;
  if (off_steps > most_steps_off_line) {
    problems.push_back(
        fmt::format("the path leaves its lines by up to {:.3f} mm", results.max_deviation_mm));
  }
  const std::string unasked =
      by_axis(results, [](const AxisResult& axis) { return axis.unasked_steps; });
  if (!unasked.empty()) {
    problems.push_back(fmt::format("steps that no line asks for: {}", unasked));
  }
  if (const std::uint64_t count = findings.lines_lost; count > 0) {
    problems.push_back(
        fmt::format("{} line{} of the file lost: never carried out", count, plural(count)));
  }
  if (const std::uint64_t count = results.underruns; count > 0) {
    problems.push_back(fmt::format("{} underrun{}: the motion stopped dead for want of lines",
                                   count, plural(count)));
  }
  const std::string illegal =
      by_axis(results, [](const AxisResult& axis) { return axis.illegal_pulses; });
  if (!illegal.empty()) {
    problems.push_back(fmt::format("pulses that break the driver's times: {}", illegal));
  }
  const std::string lost = by_axis(results, [](const AxisResult& axis) {
    return axis.disabled_pulses + axis.slipped_steps + axis.frame_steps;
  });
  if (!lost.empty()) {
    problems.push_back(fmt::format("steps lost by the motors: {}", lost));
  }
}

}  // namespace report
