// SPDX-License-Identifier: Apache-2.0
// What a plan says of short files whose motion is easily calculated.
#include <gmock/gmock.h>

#include <cmath>
#include <initializer_list>

#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;

constexpr std::uint32_t clock_hz = 50'000'000;

Plan plan_of(std::initializer_list<std::string_view> lines) {
  PrintPlanner planner(clock_hz);
  std::size_t number = 0;
  for (const std::string_view line : lines) {
    if (!planner.take(++number, line)) break;
  }
  return planner.finish();
}

// So little jerk that a line begins and ends with the speed in the middle of its first step.
constexpr std::string_view slow_start = "M205 X0.1 Y0.1 Z0.1 E0.1";

double first_speed(double acceleration, double step_mm) {
  return std::sqrt(acceleration * step_mm);
}

double trapezoid_seconds(double mm, double speed, double acceleration, double step_mm) {
  const double change = speed - first_speed(acceleration, step_mm);
  return mm / speed + change * change / (speed * acceleration);
}

TEST(plan, of_a_long_line_has_the_time_and_the_peaks_of_a_trapezoid) {
  const Plan plan = plan_of({slow_start, "M204 T1000", "G1 X100 F6000"});
  EXPECT_THAT(plan.moving_seconds, DoubleNear(trapezoid_seconds(100, 100, 1000, 1 / 80.0), 0.0005));
  EXPECT_THAT(plan.axes[0].max_speed_mm_per_s, DoubleNear(100, 0.1));
  EXPECT_THAT(plan.axes[0].max_acceleration_mm_per_s2, DoubleNear(1000, 5));
  EXPECT_THAT(plan.axes[0].max_step_rate_hz, DoubleNear(8000, 8));
  EXPECT_EQ(plan.axes[0].steps_forward, 8000u);
  EXPECT_EQ(plan.axes[0].steps_backward, 0u);
  EXPECT_EQ(plan.axes[1].max_speed_mm_per_s, 0);
  EXPECT_EQ(plan.moves, 1u);
}

TEST(plan, of_a_short_line_has_the_time_of_a_triangle) {
  const Plan plan = plan_of({slow_start, "M204 T1000", "G1 X4 F12000"});
  const double first = first_speed(1000, 1 / 80.0);
  const double highest = std::sqrt(first * first + 4.0 * 1000);
  EXPECT_THAT(plan.moving_seconds, DoubleNear(2 * (highest - first) / 1000, 0.0005));
  EXPECT_THAT(plan.axes[0].max_speed_mm_per_s, DoubleNear(highest, 0.1));
}

// Diagonal: each axis has its part of the speed.
TEST(plan, shares_speed_and_acceleration_between_the_axes) {
  const Plan plan = plan_of({slow_start, "M204 T1000", "G1 X60 Y80 F6000"});
  EXPECT_THAT(plan.moving_seconds, DoubleNear(trapezoid_seconds(100, 100, 1000, 1 / 64.0), 0.0005));
  EXPECT_THAT(plan.axes[0].max_speed_mm_per_s, DoubleNear(60, 0.1));
  EXPECT_THAT(plan.axes[1].max_acceleration_mm_per_s2, DoubleNear(800, 5));
}

TEST(plan, counts_pauses_but_no_heating) {
  const Plan plan = plan_of({"M109 S215", "M190 S60", "M109 R180", "G4 S2", "G1 X1 F600"});
  EXPECT_THAT(plan.refused, testing::IsEmpty());
  EXPECT_THAT(plan.seconds - plan.moving_seconds, DoubleNear(2, 0.2));
  EXPECT_THAT(plan.first_move_seconds, DoubleNear(2, 0.2));
}

TEST(plan, is_slower_at_half_the_speed_factor) {
  const Plan normal = plan_of({slow_start, "G1 X100 F600"});
  const Plan slow = plan_of({slow_start, "M220 S50", "G1 X100 F600"});
  EXPECT_THAT(normal.moving_seconds, DoubleNear(10, 0.05));
  EXPECT_THAT(slow.moving_seconds, DoubleNear(20, 0.1));
  EXPECT_THAT(slow.axes[0].max_speed_mm_per_s, DoubleNear(5, 0.01));
}

TEST(plan, homes_to_the_end_stops_and_knows_where_they_are) {
  const Plan plan = plan_of({"G28", "G1 X200 F6000", "G28 X", "G1 X201 F6000", "G1 X10"});
  EXPECT_EQ(plan.fault, "");
  ASSERT_EQ(plan.refused.size(), 1u);
  EXPECT_EQ(plan.refused[0].file_line, 4u);
  // 20 mm, 5 mm back and again; 200 mm there and back; and 10 mm.
  EXPECT_THAT(static_cast<double>(plan.axes[0].steps_backward) / 80,
              DoubleNear(20 + 5 + 200 + 5, 0.1));
  EXPECT_THAT(static_cast<double>(plan.axes[0].steps_forward) / 80,
              DoubleNear(5 + 200 + 5 + 10, 0.1));
}

TEST(plan, refuses_lines_of_any_length_that_the_printer_would_refuse) {
  const std::string long_line = "G1 X10 F3000 ;" + std::string(100'000, 'x');
  const Plan plan = plan_of({"G1 X1 F600", long_line, "G1 X2"});
  ASSERT_EQ(plan.refused.size(), 1u);
  EXPECT_EQ(plan.refused[0].file_line, 2u);
}

TEST(plan, names_refused_lines_with_their_reasons) {
  const Plan plan =
      plan_of({"G1 X1 F600", "M9999", "G1 X1.2.3", "M104 S900", "G1 X2", "M109 R900"});
  ASSERT_EQ(plan.refused.size(), 4u);
  EXPECT_EQ(plan.refused[0].file_line, 2u);
  EXPECT_EQ(plan.refused[0].text, "M9999");
  EXPECT_THAT(plan.refused[0].reason, HasSubstr("Unknown command"));
  EXPECT_EQ(plan.refused[1].file_line, 3u);
  EXPECT_EQ(plan.refused[2].file_line, 4u);
  EXPECT_THAT(plan.refused[2].reason, HasSubstr("highest target"));
  EXPECT_EQ(plan.refused[3].text, "M109 R900");
  EXPECT_EQ(plan.axes[0].steps_forward, 160u);
}

TEST(plan, ends_at_the_emergency_stop) {
  const Plan plan = plan_of({"G1 X1 F600", "M112", "G1 X2"});
  EXPECT_THAT(plan.fault, HasSubstr("emergency"));
  EXPECT_EQ(plan.axes[0].steps_forward, 80u);
}

TEST(plan, answers_the_questions_of_a_file) {
  const Plan plan = plan_of({"G1 X1 F600", "M0 Change it", "M600", "M601", "G1 X2"});
  EXPECT_THAT(plan.refused, testing::IsEmpty());
  EXPECT_EQ(plan.axes[0].steps_forward, 160u);
}

// A hop of Z without filament is no layer, nor is a line that moves Z as it extrudes.
TEST(plan, divides_the_time_between_the_layers) {
  const Plan plan =
      plan_of({slow_start, "M83", "G1 Z0.2 F600", "G1 X30 E1 F600", "G1 Z1", "G1 Z0.2", "G1 X60 E1",
               "G1 X62 Z0.3 E0.1", "G1 X65 Z0.4 E0.1", "G1 X5 E2", "G1 E-1", "G1 E1"});
  ASSERT_EQ(plan.layers.size(), 2u);
  EXPECT_THAT(plan.layers[0].z_mm, DoubleNear(0.2, 1e-9));
  EXPECT_THAT(plan.layers[1].z_mm, DoubleNear(0.4, 1e-9));
  EXPECT_GT(plan.layers[0].seconds, 6.5);
  EXPECT_LT(plan.layers[0].seconds, 7.2);
  EXPECT_THAT(plan.layers[0].begin_seconds + plan.layers[0].seconds,
              DoubleNear(plan.layers[1].begin_seconds, 1e-9));
  EXPECT_THAT(plan.layers[1].begin_seconds + plan.layers[1].seconds,
              DoubleNear(plan.seconds, 1e-9));
}

TEST(plan, adds_up_the_filament) {
  const Plan plan = plan_of({"M83", "G1 X10 E5 F600", "G1 E-2", "G1 E2", "G1 X0 E1.5"});
  EXPECT_THAT(plan.filament_mm, DoubleNear(6.5, 0.002));
  EXPECT_EQ(plan.axes[3].steps_backward, 1000u);
}

TEST(plan, has_no_underrun_in_many_short_lines) {
  PrintPlanner planner(clock_hz);
  for (int i = 1; i <= 3000; ++i) {
    planner.take(static_cast<std::size_t>(i), "G1 X" + std::to_string(0.05 * i) + " Y" +
                                                  std::to_string(i % 2 * 0.02) + " F9000");
  }
  const Plan plan = planner.finish();
  EXPECT_EQ(plan.underruns, 0u);
  EXPECT_EQ(plan.axes[0].steps_forward, 12'000u);
  EXPECT_GT(plan.moving_seconds, 1.0);
}

}  // namespace
}  // namespace planning
