// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/starts.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <utility>

#include "host_link/line_queue.hpp"

namespace worst_inputs {

namespace {

constexpr int lines_at_once = static_cast<int>(host_link::LineQueue::capacity);

SerialInput then(std::string lines, std::uint32_t pause_us) {
  return {{.pause_us = 0, .bytes = std::move(lines)}, {.pause_us = pause_us, .bytes = {}}};
}

// As a host sends them: no more at once than the printer takes. At the end the last one has just
// been taken over.
template <class Line>
SerialInput in_turn(std::string first, int count, Line line) {
  SerialInput input{{.pause_us = 0, .bytes = std::move(first)}};
  for (int i = 0; i < count; ++i) {
    if (i % lines_at_once == 0) input.push_back({.pause_us = 0, .bytes = {}, .waits = true});
    input.back().bytes += line(i);
  }
  input.push_back({.pause_us = 0, .bytes = {}, .waits = true});
  return input;
}

// On and on, with so little acceleration that each line makes many before it faster; of all axes,
// each at another angle to the one before, by this command's corners.
SerialInput slow_lines(std::string_view corners) {
  return in_turn(fmt::format("M83\nM204 P20 T20\nM205 {}\nG1 F12000\n", corners), 56, [](int i) {
    const int line = i + 1;
    return fmt::format("G1X{:.1f}Y{:.1f}Z{:.1f}E.1{}\n", 100 + 1.3 * line + line % 2,
                       100 + 1.1 * line - line % 3, 10 + 0.3 * line + 0.2 * (line % 2), line % 3);
  });
}

// The smallest lines that a machine is given. So long after the last one the step generator will
// soon take four at once.
SerialInput small_lines(double millimeters, int acceleration, int jerk, std::uint32_t pause_us) {
  SerialInput input =
      in_turn(fmt::format("M83\nM201 X{0} Y{0} E{0}\nM204 P{0} T{0}\n"
                          "M203 X300 Y300 E200\nM205 X{1} Y{1} E{1}\n"
                          "G1 F18000\n",
                          acceleration, jerk),
              24, [millimeters](int line) {
                return fmt::format("G1X{:.2f}Y{:.2f}E.005\n", 100 + millimeters * (line % 2),
                                   100 + millimeters * (line / 2 % 2));
              });
  input.push_back({.pause_us = pause_us, .bytes = {}});
  return input;
}

}  // namespace

std::vector<Start> starts() {
  constexpr std::uint32_t moment_us = 30'000, half_a_moment_us = 15'000, interval_us = 1'004'000;
  return {
      {"at rest", {}},
      {"slow lines", slow_lines("X30 Y30 Z5 E20")},
      {"slow lines, by junction deviation", slow_lines("J0.02")},
      {"small lines, large jerk", small_lines(0.08, 20'000, 5, moment_us)},
      {"small lines", small_lines(0.1, 20'000, 1, moment_us)},
      {"small lines, a little longer", small_lines(0.12, 20'000, 1, half_a_moment_us)},
      {"an arc", then("G2 X140 I20 J0 F3000\n", moment_us)},
      {"near the end stops", in_turn("G1 X0.4 Y0.4 Z0.3 F9000\n", 1, [](int) { return "M400\n"; })},
      {"homing", then("G28\n", moment_us)},
      {"a heater that is waited for", then("M109 S230\n", moment_us)},
      {"reports that are due", then("M155 S1\nM154 S1\n", interval_us)},
  };
}

}  // namespace worst_inputs
