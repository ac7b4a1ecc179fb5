// SPDX-License-Identifier: Apache-2.0
// The summary of a print on the terminal: verdict, figures, and the faulty lines.
#include "tools/command/print_summary.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "tools/command/output.hpp"

namespace command {

namespace {

constexpr std::size_t most_shown = 10;
constexpr const char* red = "\x1b[31m";
constexpr const char* green = "\x1b[32m";
constexpr const char* plain = "\x1b[0m";

// As much as fits a screen; the report has everything.
template <class Line>
void show_lines(const char* title, const std::vector<Line>& lines, std::uint64_t count,
                void (*show)(const Line& line)) {
  if (lines.empty()) return;
  say("  {}:\n", title);
  for (std::size_t i = 0; i < std::min(lines.size(), most_shown); ++i) show(lines[i]);
  if (count > most_shown) say("    and {} more: see the report\n", count - most_shown);
}

void show_refused(const report::RefusedLine& line) {
  say("    line {}: {:.60}: {}\n", line.file_line, line.text, line.reason);
}

void show_missed(const report::MissedPoint& point) {
  std::string axes;
  for (std::size_t i = 0; i < point.axes.size(); ++i) {
    const report::AxisArrival& axis = point.axes[i];
    if (axis.missed) {
      axes += fmt::format("{}{} {:.4f} instead of {:.4f} mm", axes.empty() ? "" : ", ",
                          report::axis_titles[i], axis.reached_mm, axis.wanted_mm);
    }
  }
  say("    line {}: {:.60}: {}\n", point.file_line, point.text, axes);
}

void show_verdict(const report::Results& results) {
  const bool colours = isatty(STDOUT_FILENO) != 0;
  say("{}: {}, {}{}{}\n", results.file, name_of(results.outcome),
      colours ? (results.good() ? green : red) : "", results.good() ? "good" : "BAD",
      colours ? plain : "");
  for (const std::string& problem : results.findings.problems) say("  ! {}\n", problem);
}

// Suggests a clock of real boards where the processor limited the motion.
void show_clock_advice(const report::Results& results) {
  constexpr double worth_a_word = 0.1;
  constexpr std::array round_clocks_hz{8'000'000U, 16'000'000U, 25'000'000U, 50'000'000U};
  const double seconds = results.processor_saturated_seconds;
  const bool limit =
      seconds > worth_a_word * results.moving_seconds || (seconds > 0 && results.underruns > 0);
  const auto* next = std::ranges::find_if(
      round_clocks_hz, [&](std::uint32_t clock_hz) { return clock_hz > results.clock_hz; });
  if (limit && next != round_clocks_hz.end()) {
    say("  the processor was the limit for {:.1f} of {:.1f} s of motion: try --clock-hz {}\n",
        seconds, results.moving_seconds, *next);
  }
}

}  // namespace

void print_summary(const PrintOptions& options, const report::Results& results) {
  const report::Findings& findings = results.findings;
  show_verdict(results);
  say("  {:.1f} s on the printer at {:.3g} MHz, simulated in {:.1f} s ({:.2f} million clocks/s)\n",
      results.simulated_seconds, results.clock_hz * 1e-6, results.wall_seconds,
      static_cast<double>(results.cycles) / std::max(results.wall_seconds, 1e-9) * 1e-6);
  say("  {} lines, {} resends, {} lost; {} refused that should move or heat, {} warning{}\n",
      results.lines_sent, results.resends, findings.lines_lost, findings.refused_count,
      findings.warning_count, findings.warning_count == 1 ? "" : "s");
  const std::uint64_t points = results.points_reached + results.points_missed;
  if (results.points_shaped == 0) {
    say("  {} of {} points reached to the step on X, Y, Z and E, at most {:.4f} mm off the lines\n",
        results.points_reached, points, results.max_deviation_mm);
  } else {
    say("  {} of {} points reached on X, Y, Z and E\n", results.points_reached, points);
    say("    {} to the step, at most {:.4f} mm off the lines\n",
        results.points_reached - results.points_shaped, results.max_deviation_mm);
    say("    {} with input shaping or linear advance: to the step where the axes rest, corners "
        "rounded by at most {:.4f} mm\n",
        results.points_shaped, results.max_shaping_mm);
  }
  std::uint64_t illegal = 0, lost = 0;
  for (const report::AxisResult& axis : results.axes) {
    illegal += axis.illegal_pulses;
    lost += axis.disabled_pulses + axis.slipped_steps + axis.frame_steps;
  }
  say("  {} illegal pulses, {} steps lost otherwise, {} underruns, processor {:.1f} % busy\n",
      illegal, lost, results.underruns, results.processor_busy_percent);
  if (options.printer.stepping == "software") {
    say("  steps made in software: {} ticks were late\n", results.late_ticks);
  }
  show_clock_advice(results);
  show_lines("refused", findings.refused, findings.refused_count, show_refused);
  show_lines("missed", findings.missed, results.points_missed, show_missed);
  show_lines("warnings", findings.warnings, findings.warning_count, show_refused);
  say("  {} messages of the chip; report: {}\n", results.messages.size(),
      (options.report / "report.html").string());
}

}  // namespace command
