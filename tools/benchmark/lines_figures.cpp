// SPDX-License-Identifier: Apache-2.0
// The lines, the runs, and the figures as a table and as JSON.
#include "tools/benchmark/lines_figures.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "tools/benchmark/clock_parts.hpp"

namespace benchmarks {

namespace {

constexpr std::uint32_t clock_hz = 50'000'000;
constexpr std::size_t leading_lines = 150;
constexpr std::size_t measured_lines = 600, quick_measured_lines = 60;
constexpr double hot_c = 220;
// A prime, so that no loop of the firmware keeps step with it.
constexpr sim::Clock sample_clocks = 211;
constexpr double bits_per_byte = 10, ok_bytes = 3;
// Lines in flight: Printrun and OctoPrint wait for each answer, printcore has 2 after a Resend,
// Cura 4, and 8 are as many as fit.
constexpr std::size_t windows[]{1, 2, 4, 8};
constexpr std::array parts{"line",      "parse", "execute", "plan",
                           "hand over", "heat",  "loop",    "library"};

struct Lines {
  std::vector<std::string> lines;
  std::size_t first_measured{};
};

// `N345 G1 X29.5 Y29.5 E.01*99`: 27 characters with number and checksum, of a machine that is so
// quick that its motion bounds nothing.
Lines lines_of(std::size_t measured) {
  NumberedLines lines;
  for (const char* command : {"G4 P800", "M203 X5000 Y5000", "M201 X100000 Y100000",
                              "M204 P100000 T100000", "G92 X10 Y10", "M83", "G1 F120000"}) {
    lines.add(command);
  }
  const std::size_t first = 100;
  while (lines.lines().size() < first) lines.add("M83");
  for (std::size_t i = 0; i < leading_lines + measured; ++i) {
    const double way = 10 + 0.1 * static_cast<double>(i + 1);
    lines.add(fmt::format("G1 X{:.1f} Y{:.1f} E.01", way, way));
  }
  return {.lines = lines.lines(), .first_measured = first + leading_lines};
}

}  // namespace

std::vector<LinesFigure> measure_lines(const LinesScope& scope,
                                       const std::function<void(const std::string&)>& say) {
  const Lines lines = lines_of(scope.quick ? quick_measured_lines : measured_lines);
  std::vector<LinesFigure> figures;
  for (const auto& [baud, memory_bytes, program] : scope.programs) {
    const sim::ElfImage firmware = sim::read_elf(program);
    machine::Description description = scope.machine;
    description.memory_bytes = memory_bytes;
    for (const std::size_t window : windows) {
      say(fmt::format("printing lines at {} baud with {} KiB, {} in flight", baud,
                      memory_bytes / 1024, window));
      const LinkRun run = run_link(firmware, description,
                                   {.lines = lines.lines,
                                    .first_measured = lines.first_measured,
                                    .window = window,
                                    .clock_hz = clock_hz,
                                    .baud = baud,
                                    .hotend_c = hot_c,
                                    .sample_clocks = sample_clocks},
                                   scope.look);
      const double bytes = static_cast<double>(lines.lines[lines.first_measured].size()) + 1 +
                           (window == 1 ? ok_bytes : 0);
      LinesFigure figure{
          .baud = baud,
          .memory_kib = memory_bytes / 1024,
          .window = window,
          .lines_per_second = run.lines_per_second,
          .line_limit = baud / bits_per_byte / bytes,
          .busy_percent = run.busy_percent,
          .clocks_per_line = clock_hz * run.busy_percent / 100 / run.lines_per_second,
          .underruns = run.underruns,
          .parts = clock_parts(run.samples, program)};
      for (auto& [part, clocks] : figure.parts) clocks *= figure.clocks_per_line;
      figures.push_back(figure);
    }
  }
  return figures;
}

std::string to_json(const std::vector<LinesFigure>& figures) {
  nlohmann::ordered_json json{{"benchmark", "lines"}, {"clock_hz", clock_hz}};
  for (const LinesFigure& figure : figures) {
    json["lines"].push_back({{"baud", figure.baud},
                             {"memory_kib", figure.memory_kib},
                             {"window", figure.window},
                             {"lines_per_second", figure.lines_per_second},
                             {"line_limit_per_second", figure.line_limit},
                             {"busy_percent", figure.busy_percent},
                             {"clocks_per_line", figure.clocks_per_line},
                             {"underruns", figure.underruns},
                             {"clocks_of", figure.parts}});
  }
  return json.dump(2) + "\n";
}

std::string to_table(const std::vector<LinesFigure>& figures) {
  std::string table =
      fmt::format("{:>8} {:>4} {:>6} {:>8} {:>8} {:>6} {:>12} {:>9} ", "baud", "KiB", "window",
                  "lines/s", "line's", "busy", "clocks/line", "underruns");
  for (const char* part : parts) table += fmt::format(" {:>9}", part);
  table += '\n';
  for (const LinesFigure& figure : figures) {
    table +=
        fmt::format("{:>8} {:>4} {:>6} {:>8.0f} {:>8.0f} {:>5.1f}% {:>12.0f} {:>9} ", figure.baud,
                    figure.memory_kib, figure.window, figure.lines_per_second, figure.line_limit,
                    figure.busy_percent, figure.clocks_per_line, figure.underruns);
    for (const char* part : parts) {
      const auto found = figure.parts.find(part);
      table += fmt::format(" {:>9.0f}", found == figure.parts.end() ? 0.0 : found->second);
    }
    table += '\n';
  }
  return table;
}

}  // namespace benchmarks
