// SPDX-License-Identifier: Apache-2.0
// Which lines are sent at which speeds, and the figures as a table and as JSON.
#include "tools/benchmark/link_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "tools/benchmark/urgent_run.hpp"

namespace benchmarks {

namespace {

constexpr std::size_t line_characters = 27;
constexpr std::size_t windows[]{1, 2, 4, 8};
constexpr std::uint32_t clocks_hz[]{50'000'000, 4'000'000};
constexpr std::uint32_t least_clocks_per_bit = 4;
// So many lines fill the planner's ring and a run of them is measured.
constexpr std::size_t leading_lines = 100, quick_leading_lines = 40;
constexpr std::size_t measured_lines = 200, quick_measured_lines = 60;
// Two steps of X and Y, of a machine that can stop within the planner's ring of them from 200 mm/s:
// 5600 lines/s before motion bounds the rate.
constexpr double short_move_mm = 0.025;
constexpr double bits_per_byte = 10, ok_bytes = 3;

struct Lines {
  std::vector<std::string> lines;
  std::size_t first_measured{};
};

std::size_t leading(bool quick) { return quick ? quick_leading_lines : leading_lines; }
std::size_t measured(bool quick) { return quick ? quick_measured_lines : measured_lines; }

Lines moves(bool quick) {
  NumberedLines lines;
  lines.add("M201 X50000 Y50000");
  lines.add("M204 P50000 T50000");
  lines.add("G1 F12000");
  lines.add("G92 X10 Y10");
  const std::size_t first = lines.lines().size() + leading(quick);
  while (lines.lines().size() < first + measured(quick)) {
    // Of two digits before the point throughout.
    const double way = 10 + short_move_mm * static_cast<double>(lines.lines().size());
    lines.add_move(way, way, line_characters);
  }
  return {.lines = lines.lines(), .first_measured = first};
}

// The shortest that a person or a script sends: no number, no motion.
Lines short_lines(bool quick) {
  const std::size_t first = quick ? 5 : 20;
  return {.lines = std::vector<std::string>(first + measured(quick) / 4, "G92 E0.5"),
          .first_measured = first};
}

// As in the planner's tests (tests/motion): an arc of radius 20 mm, F12000, 3000 mm/s^2.
std::vector<std::string> arc_commands(int segments) {
  constexpr double radius_mm = 20, segment_mm = 0.2;
  std::vector<std::string> commands{"M204 P3000 T3000", "G1 F12000"};
  for (int i = 1; i <= segments; ++i) {
    const double angle = i * segment_mm / radius_mm;
    commands.push_back(fmt::format("G1 X{:.3f} Y{:.3f}", radius_mm * std::sin(angle),
                                   radius_mm * (1 - std::cos(angle))));
  }
  return commands;
}

Lines arc(bool quick) {
  NumberedLines lines;
  for (const std::string& command : arc_commands(quick ? 100 : 1200)) lines.add(command);
  lines.add("M400");
  constexpr std::size_t first = 3;  // M110, M204, G1 F
  return {.lines = lines.lines(), .first_measured = first};
}

class Measurement {
 public:
  Measurement(const LinkScope& scope, const std::function<void(const std::string&)>& say)
      : scope_(scope), say_(say) {}

  // At each baud rate that the clock permits.
  void add(std::vector<LinkFigure>& figures, const std::string& what, const Lines& lines,
           std::uint32_t clock_hz, std::size_t window) const {
    for (const auto& [baud, firmware] : scope_.firmware) {
      if (clock_hz / baud < least_clocks_per_bit) continue;
      say_(fmt::format("{} at {} MHz, {} baud, {} in flight", what, clock_hz / 1'000'000, baud,
                       window));
      LinkFigure figure{.clock_hz = clock_hz, .baud = baud, .window = window, .run = {}};
      const double bytes = static_cast<double>(lines.lines[lines.first_measured].size()) + 1 +
                           (window == 1 ? ok_bytes : 0);
      figure.line_limit = baud / bits_per_byte / bytes;
      figure.run = run_link(firmware, scope_.machine,
                            {.lines = lines.lines,
                             .first_measured = lines.first_measured,
                             .window = window,
                             .clock_hz = clock_hz,
                             .baud = baud},
                            scope_.look);
      figures.push_back(figure);
    }
  }

 private:
  const LinkScope& scope_;
  const std::function<void(const std::string&)>& say_;
};

// The job is the arc, of which lines always wait.
UrgentFigure measure_urgent(const LinkScope& scope, std::uint32_t clock_hz, bool numbered) {
  constexpr std::size_t questions = 60, quick_questions = 5, runs = 5, quick_runs = 1;
  const auto& [baud, firmware] = *scope.firmware.begin();
  std::vector<std::string> lines = arc_commands(1200);
  lines.insert(lines.begin(), "G4 P800");  // until there are temperatures
  UrgentOrder order{.lines = lines,
                    .questions = scope.quick ? quick_questions : questions,
                    .numbered = numbered,
                    .clock_hz = clock_hz,
                    .baud = baud};
  UrgentFigure figure{.clock_hz = clock_hz, .numbered = numbered};
  std::vector<double> answers, stops;
  for (std::size_t i = 0; i < (scope.quick ? quick_runs : runs); ++i) {
    order.seed = i + 1;
    const UrgentRun run = run_urgent(firmware, scope.machine, order, scope.look);
    answers.insert(answers.end(), run.answers_us.begin(), run.answers_us.end());
    stops.push_back(run.stop_us);
    order.questions = quick_questions;  // more of M112
  }
  const auto mean = [](const std::vector<double>& times) {
    return std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
  };
  figure.mean_answer_us = mean(answers);
  figure.longest_answer_us = *std::ranges::max_element(answers);
  figure.mean_stop_us = mean(stops);
  figure.longest_stop_us = *std::ranges::max_element(stops);
  return figure;
}

nlohmann::ordered_json json_of(const std::vector<UrgentFigure>& figures) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const UrgentFigure& figure : figures) {
    json.push_back({{"clock_hz", figure.clock_hz},
                    {"numbered", figure.numbered},
                    {"mean_answer_us", figure.mean_answer_us},
                    {"longest_answer_us", figure.longest_answer_us},
                    {"mean_stop_us", figure.mean_stop_us},
                    {"longest_stop_us", figure.longest_stop_us}});
  }
  return json;
}

std::string rows_of(const std::vector<UrgentFigure>& figures) {
  std::string table = fmt::format("{:<24} {:>4} {:>9} {:>20} {:>20}\n", "after a waiting G1", "MHz",
                                  "numbered", "M105 us, longest", "M112 us, longest");
  for (const UrgentFigure& figure : figures) {
    table +=
        fmt::format("{:<24} {:>4} {:>9} {:>20} {:>20}\n", "", figure.clock_hz / 1'000'000,
                    figure.numbered ? "yes" : "no",
                    fmt::format("{:.0f}, {:.0f}", figure.mean_answer_us, figure.longest_answer_us),
                    fmt::format("{:.0f}, {:.0f}", figure.mean_stop_us, figure.longest_stop_us));
  }
  return table;
}

nlohmann::ordered_json json_of(const std::vector<LinkFigure>& figures) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const LinkFigure& figure : figures) {
    json.push_back({{"clock_hz", figure.clock_hz},
                    {"baud", figure.baud},
                    {"window", figure.window},
                    {"lines_per_second", figure.run.lines_per_second},
                    {"line_limit_per_second", figure.line_limit},
                    {"busy_percent", figure.run.busy_percent},
                    {"motion_seconds", figure.run.motion_seconds},
                    {"underruns", figure.run.underruns}});
    if (figure.window != 1) continue;
    json.back()["mean_latency_us"] = figure.run.mean_latency_us;
    json.back()["longest_latency_us"] = figure.run.longest_latency_us;
  }
  return json;
}

std::string rows_of(const char* what, const std::vector<LinkFigure>& figures) {
  std::string table =
      fmt::format("{:<24} {:>4} {:>8} {:>7} {:>9} {:>9} {:>7} {:>20} {:>9}\n", what, "MHz", "baud",
                  "window", "lines/s", "line's", "busy", "latency us, longest", "motion s");
  for (const LinkFigure& figure : figures) {
    const LinkRun& run = figure.run;
    const std::string latency =
        figure.window == 1
            ? fmt::format("{:.0f}, {:.0f}", run.mean_latency_us, run.longest_latency_us)
            : "";
    table +=
        fmt::format("{:<24} {:>4} {:>8} {:>7} {:>9.0f} {:>9.0f} {:>6.1f}% {:>20} {:>9.3f}\n", "",
                    figure.clock_hz / 1'000'000, figure.baud, figure.window, run.lines_per_second,
                    figure.line_limit, run.busy_percent, latency, run.motion_seconds);
  }
  return table;
}

}  // namespace

LinkFigures measure_link(const LinkScope& scope,
                         const std::function<void(const std::string&)>& say) {
  LinkFigures figures;
  const Measurement measurement(scope, say);
  for (const std::uint32_t clock_hz : clocks_hz) {
    measurement.add(figures.short_lines, "lines of 8 characters", short_lines(scope.quick),
                    clock_hz, 1);
    for (const std::size_t window : windows) {
      measurement.add(figures.rates, "lines of 27 characters", moves(scope.quick), clock_hz,
                      window);
    }
    measurement.add(figures.arcs, "an arc of short segments", arc(scope.quick), clock_hz, 1);
    for (const bool numbered : {false, true}) {
      say(fmt::format("M105 and M112 at {} MHz, {} number", clock_hz / 1'000'000,
                      numbered ? "with" : "without"));
      figures.urgent.push_back(measure_urgent(scope, clock_hz, numbered));
    }
  }
  return figures;
}

std::string to_json(const LinkFigures& figures) {
  const nlohmann::ordered_json json{{"benchmark", "link"},
                                    {"lines_of_27_characters", json_of(figures.rates)},
                                    {"lines_of_8_characters", json_of(figures.short_lines)},
                                    {"arc_of_1200_segments", json_of(figures.arcs)},
                                    {"behind_a_waiting_move", json_of(figures.urgent)}};
  return json.dump(2) + "\n";
}

std::string to_table(const LinkFigures& figures) {
  return rows_of("lines of 27 characters", figures.rates) +
         rows_of("lines of 8 characters", figures.short_lines) +
         rows_of("arc of 1200 segments", figures.arcs) + rows_of(figures.urgent);
}

}  // namespace benchmarks
