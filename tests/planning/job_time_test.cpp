// SPDX-License-Identifier: Apache-2.0
// The time of sliced files on a machine with limits as Klipper's users have them, against a planner
// by Klipper's rules that looks ahead over the whole file.
#include <gmock/gmock.h>

#include <string>

#include "directories.hpp"
#include "machine_generator/description.hpp"
#include "sim/devices/gcode_file.hpp"
#include "tests/planning/square_corner_planner.hpp"
#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

constexpr std::uint32_t clock_hz = 50'000'000;

// What moves, or says how; limits are those of the machine, and it is at home already.
bool counts(const std::string& line) {
  for (const char* code : {"G0 ", "G1 ", "G90", "G91", "G92", "M82", "M83"}) {
    if (line.starts_with(code)) return true;
  }
  return false;
}

struct Times {
  double firmware{}, reference{};
};

Times times_of(const std::string& file) {
  auto machine =
      machine_generator::read_machine(PROJECT_DIRECTORY "/firmware/machines/bed_slinger.toml");
  machine.description.name = machine.name;
  PrintPlanner planner(machine.description, clock_hz);
  SquareCornerPlanner reference{SquareCornerLimits()};
  const auto commands = devices::read_gcode_file(PROJECT_DIRECTORY "/examples/" + file).value();
  for (const auto& command : commands) {
    if (!counts(command.text)) continue;
    planner.take(command.file_line, command.text);
    reference.take(command.text);
  }
  const Plan plan = planner.finish();
  EXPECT_THAT(plan.refused, testing::IsEmpty());
  EXPECT_EQ(plan.underruns, 0u);
  const double highest[]{300, 300, 20, 80};
  for (std::size_t i = 0; i < axis_count; ++i) {
    EXPECT_LE(plan.axes[i].max_speed_mm_per_s, highest[i] * 1.001) << i;
  }
  return {.firmware = plan.seconds - plan.first_move_seconds, .reference = reference.seconds()};
}

class JobTime : public testing::TestWithParam<const char*> {};

TEST_P(JobTime, is_at_most_a_hundredth_above_klippers) {
  const Times times = times_of(GetParam());
  std::printf("%s: %.2f s, by Klipper's rules %.2f s: %+.2f %%\n", GetParam(), times.firmware,
              times.reference, 100 * (times.firmware / times.reference - 1));
  EXPECT_LE(times.firmware, 1.01 * times.reference);
  // Nor is it so much faster that it could not be by the same limits.
  EXPECT_GE(times.firmware, 0.97 * times.reference);
}

INSTANTIATE_TEST_SUITE_P(examples, JobTime,
                         testing::Values("washer.gcode", "cube20_02_marlin.gcode",
                                         "endstop_bracket_02_marlin.gcode"));

// A square of 10 mm and a line back, by hand.
TEST(square_corner_planner, takes_the_time_of_trapezoids) {
  SquareCornerPlanner planner{SquareCornerLimits()};
  for (const char* line : {"G1 X10 F6000", "G1 Y10", "G1 X0 E1 F6000"}) planner.take(line);
  const auto ramp = [](double from, double to) { return (to - from) / 3000; };
  const auto way = [](double from, double to) { return (to * to - from * from) / 6000; };
  // 100 mm/s, 5 mm/s in the corners.
  const double ends = ramp(0, 100) + ramp(5, 100) + (10 - way(0, 100) - way(5, 100)) / 100;
  const double middle = 2 * ramp(5, 100) + (10 - 2 * way(5, 100)) / 100;
  EXPECT_NEAR(planner.seconds(), 2 * ends + middle, 1e-9);
}

}  // namespace
}  // namespace planning
