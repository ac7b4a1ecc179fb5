// SPDX-License-Identifier: Apache-2.0
// How long a question waits on the whole chip at 4 MHz, while a job of lines as short as it can
// take keeps the processor busy: shorter than a host's user can notice, and than the gap in which
// other lines would pile up.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/machine/description.hpp"
#include "sim/simulation/elf_image.hpp"
#include "tests/loaded_printer.hpp"
#include "tools/benchmark/urgent_run.hpp"

namespace {

constexpr double longest_answer_us = 10'000;

// Segments of 0.2 mm of a circle, after the first temperatures.
std::vector<std::string> arc() {
  std::vector<std::string> lines{"G4 P800", "M204 P3000 T3000", "G1 F12000"};
  for (int i = 1; i <= 1200; ++i) {
    const double angle = i * 0.01;
    lines.push_back(
        fmt::format("G1 X{:.3f} Y{:.3f}", 20 * std::sin(angle), 20 * (1 - std::cos(angle))));
  }
  return lines;
}

void expect_answers_in_time(bool numbered, std::size_t in_flight) {
  const auto description = tests::default_machine();
  const auto run = benchmarks::run_urgent(sim::read_elf(tests::firmware_file), description,
                                          {.lines = arc(),
                                           .questions = 50,
                                           .in_flight = in_flight,
                                           .numbered = numbered,
                                           .clock_hz = 4'000'000,
                                           .baud = description.baud},
                                          [] {});
  ASSERT_EQ(run.answers_us.size(), 50u);
  EXPECT_LT(*std::ranges::max_element(run.answers_us), longest_answer_us);
  EXPECT_LT(run.stop_us, longest_answer_us);
}

TEST(answer_time, of_a_person_is_short_while_lines_wait) { expect_answers_in_time(false, 4); }

// OctoPrint numbers what a person asks, and has one line in flight.
TEST(answer_time, of_a_host_with_one_line_in_flight_is_short) { expect_answers_in_time(true, 1); }

}  // namespace
