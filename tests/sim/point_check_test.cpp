// SPDX-License-Identifier: Apache-2.0
// The judge of the steps: right ones pass on all axes, each kind of wrong ones is found.
#include "sim/report/point_check.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace {

using devices::StepEdge;
using report::Steps;
using testing::ElementsAre;

constexpr sim::ClockRate rate(4'000'000);

// An ideal printer: walks each command's line with single steps along the ideal positions.
class PointCheckTest : public testing::Test {
 protected:
  static constexpr std::array<double, 4> steps_per_mm{80, 80, 2560, 500};

  void send(const std::string& command, bool executed = true) {
    begin(command);
    if (executed && command.starts_with("G28")) {
      go_to(0, 0);
    }
    end(executed);
  }
  void begin(const std::string& command) { check.command_sent(++clock, ++file_line, command); }
  void end(bool executed = true) { check.command_acknowledged(++clock, file_line, "", executed); }

  void step(std::size_t axis, int direction) {
    position[axis] += direction;
    check.stepped({clock, axis, direction, position[axis]});
  }
  // In small steps along the line, like a Bresenham walk. E and Z stay where they are if not given.
  void go_to(double x_mm, double y_mm) {
    go_to(steps(0, x_mm), steps(1, y_mm), position[2], position[3]);
  }
  void go_to(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t e) {
    const Steps from = position, to{x, y, z, e};
    std::int64_t ticks = 0;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      ticks = std::max(ticks, std::abs(to[axis] - from[axis]));
    }
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
      clock += 100;
      for (std::size_t axis = 0; axis < 4; ++axis) {
        const auto ideal =
            static_cast<double>((to[axis] - from[axis]) * tick) / static_cast<double>(ticks);
        const std::int64_t next = from[axis] + std::llround(ideal);
        if (next != position[axis]) {
          step(axis, next > position[axis] ? 1 : -1);
        }
      }
    }
  }
  static std::int64_t steps(std::size_t axis, double mm) {
    return std::llround(mm * steps_per_mm[axis]);
  }
  std::uint64_t reached() const { return check.judgement().reached; }
  std::uint64_t missed() const { return check.judgement().missed; }
  report::Steps unasked() const { return check.judgement().unasked_steps; }

  Steps position{1234, 567, 0, 0};
  std::uint64_t clock = 0;
  std::size_t file_line = 0;
  report::PointCheck check{steps_per_mm, {1234, 567, 0, 0}, rate};
};

TEST_F(PointCheckTest, finds_lines_on_which_z_or_e_goes_by_itself) {
  send("G28 X Y");
  send("M83");
  send("G1 X10 E1 F1200");
  go_to(800, 0, 0, 500);
  EXPECT_EQ(check.lines_apart(), 0u);
  send("G1 X20 E1");
  go_to(1600, 0, 0, 500);
  go_to(1600, 0, 0, 1000);
  send("G1 X10 Y5 Z1");
  go_to(1600, 0, 2560, 1000);
  go_to(800, 400, 2560, 1000);
  send("M400");
  EXPECT_EQ(check.lines_apart(), 2u);
  EXPECT_EQ(missed(), 0u);
}

TEST_F(PointCheckTest, finds_homing_that_ends_away_from_the_end_stop) {
  send("G28 X Y");
  send("G1 X30 Y1 F1200");
  go_to(30, 1);
  EXPECT_THAT(check.judgement().homed_elsewhere, ElementsAre(false, false, false, false));
  begin("G28 X");
  end();
  EXPECT_THAT(check.judgement().homed_elsewhere, ElementsAre(true, false, false, false));
}

TEST_F(PointCheckTest, finds_motion_after_the_last_line) {
  send("G28 X Y");
  send("G1 X3 F1200");
  go_to(3, 0);
  send("M400");
  clock += 1000;
  EXPECT_THAT(check.judgement().moved_after_end, ElementsAre(false, false, false, false));
  go_to(240, 0, 5, 0);
  clock += 1000;
  EXPECT_THAT(check.judgement().moved_after_end, ElementsAre(false, false, true, false));
}

TEST_F(PointCheckTest, passes_a_path_that_keeps_to_the_lines) {
  send("G28 X Y");
  send("G1 X10.001 Y5.503 F1200");
  send("G1 X20.3 Y5.503");
  send("G1 X20.3 Y7");
  go_to(10.001, 5.503);
  go_to(20.3, 5.503);
  go_to(20.3, 7);
  send("M400");
  EXPECT_EQ(missed(), 0U);
  EXPECT_EQ(reached(), 3U);
  EXPECT_THAT(unasked(), ElementsAre(0, 0, 0, 0));
  EXPECT_LT(check.max_deviation_mm(), 1.0 / 80);
  EXPECT_NEAR(check.length_mm(), std::hypot(10.001, 5.503) + (20.3 - 10.001) + (7 - 5.503), 1e-9);
}

TEST_F(PointCheckTest, measures_how_far_a_path_leaves_the_line) {
  send("G28 X Y");
  send("G1 X10 Y0");
  go_to(5, 0);
  go_to(5, 0.25);
  go_to(10, 0.25);
  go_to(10, 0);
  send("M400");
  EXPECT_NEAR(check.max_deviation_mm(), 0.25, 1e-9);
  EXPECT_THAT(unasked(), ElementsAre(0, 40, 0, 0));
}

TEST_F(PointCheckTest, misses_a_point_that_the_edges_cut_off) {
  send("G28 X Y");
  send("G1 X10 Y0");
  send("G1 X10 Y10");
  go_to(9.95, 0);
  go_to(9.95, 10);
  go_to(10, 10);
  send("M400");
  EXPECT_EQ(missed(), 1U);
  EXPECT_EQ(reached(), 1U);
  EXPECT_NEAR(check.max_deviation_mm(), 0.05, 1e-9);
  const report::MissedPoint point = check.judgement().list.at(0);
  EXPECT_EQ(point.file_line, 2U);
  EXPECT_EQ(point.text, "G1 X10 Y0");
  EXPECT_TRUE(point.axes[0].missed);
  EXPECT_FALSE(point.axes[1].missed);
  EXPECT_EQ(point.axes[0].wanted_steps, 800);
  EXPECT_EQ(point.axes[0].reached_steps, 796);
  EXPECT_EQ(point.axes[0].wanted_mm, 10);
  EXPECT_EQ(point.axes[0].reached_mm, 9.95);
}

TEST_F(PointCheckTest, misses_the_end_where_steps_are_lost) {
  send("G28 X Y");
  send("G1 X10 Y0");
  go_to(8, 0);
  send("M400");
  EXPECT_EQ(missed(), 1U);
  EXPECT_NEAR(check.max_deviation_mm(), 2.0, 1e-9);
}

TEST_F(PointCheckTest, misses_a_point_by_a_single_step_of_each_axis) {
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const std::uint64_t before = check.judgement().missed_by_axis[axis];
    send("G91");
    send("G1 X1 Y1 Z1 E1");
    Steps to{position[0] + 80, position[1] + 80, position[2] + 2560, position[3] + 500};
    to[axis] -= 1;
    go_to(to[0], to[1], to[2], to[3]);
    send("M400");
    EXPECT_EQ(missed(), axis + 1) << axis;
    EXPECT_EQ(check.judgement().missed_by_axis[axis], before + 1) << axis;
    step(axis, 1);  // the next line begins where it should
  }
}

TEST_F(PointCheckTest, misses_all_points_behind_a_lost_step_and_finds_none_of_them_wrong_twice) {
  send("G28 X Y");
  for (int i = 1; i <= 20; ++i) {
    send("G1 X" + std::to_string(i) + " Y" + std::to_string(i % 2) + " E" + std::to_string(i));
  }
  for (int i = 1; i <= 20; ++i) {
    go_to(80 * i - (i > 5 ? 1 : 0), 80 * (i % 2), 0, 500 * i);
  }
  send("M400");
  EXPECT_EQ(reached(), 5U);
  EXPECT_EQ(missed(), 15U);
  EXPECT_THAT(check.judgement().missed_by_axis, ElementsAre(15, 0, 0, 0));
}

TEST_F(PointCheckTest, rounds_to_the_nearest_step_and_halves_away_from_zero) {
  send("G28 X Y");
  // A step is 0.0125 mm: 0.00625 is the half.
  for (const auto& [word, step] : std::vector<std::pair<std::string, std::int64_t>>{
           {"0.00625", 1},
           {"0.006249", 0},
           {"-0.00625", -1},
           {"0.01875", 2},
           {"0.018749", 1},
           {"0.0062499999", 1}}) {  // the seventh decimal rounds up
    send("G1 X" + word);
    go_to(step, 0, 0, 0);
    send("M400");
    EXPECT_EQ(missed(), 0U) << word;
  }
  EXPECT_EQ(reached(), 6U);
}

TEST_F(PointCheckTest, keeps_the_sum_of_moves_shorter_than_a_step) {
  send("G28 X Y");
  send("G91");
  for (int i = 1; i <= 200; ++i) {
    send("G1 X0.005");
    go_to((i * 4 + 5) / 10, 0, 0, 0);  // 0.4 steps each, rounded
  }
  send("M400");
  EXPECT_EQ(position[0], 80);
  EXPECT_EQ(reached(), 200U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, misses_where_moves_shorter_than_a_step_are_lost) {
  send("G28 X Y");
  send("G1 X20");
  go_to(20, 0);
  for (int i = 1; i <= 200; ++i) {
    send("G1 X" + std::to_string(20 + 0.005 * i));
  }
  send("G1 X20");
  go_to(19, 0);
  send("M400");
  EXPECT_EQ(reached(), 2U);  // X20 and X20.005, which rounds to the same step
  EXPECT_EQ(missed(), 200U);
}

TEST_F(PointCheckTest, judges_lines_that_step_no_axis_by_where_the_axes_stand) {
  send("G28 X Y");
  send("G1 X10");
  send("G1 X10.001");
  send("G1 X10");
  go_to(10, 0);
  send("G1 Y0.001");
  send("M400");
  EXPECT_EQ(reached(), 4U);
  go_to(10.05, 0);  // a stray motion
  send("G1 Y0");
  send("M400");
  EXPECT_EQ(missed(), 1U);
}

TEST_F(PointCheckTest, finds_steps_that_no_line_asks_for_although_all_points_are_reached) {
  send("G28 X Y");
  send("G1 X10");
  go_to(10, 0);
  go_to(800, 0, 0, 7);
  go_to(800, 0, 0, 0);
  send("G1 X20");
  go_to(20, 0);
  send("M400");
  EXPECT_EQ(missed(), 0U);
  EXPECT_THAT(unasked(), ElementsAre(0, 0, 0, 14));
}

TEST_F(PointCheckTest, misses_a_last_point_that_the_machine_has_left_again) {
  send("G28 X Y");
  send("G1 X10");
  go_to(10, 0);
  go_to(10.1, 0);
  send("M400");
  EXPECT_EQ(reached(), 0U);
  EXPECT_EQ(missed(), 1U);
}

TEST_F(PointCheckTest, expects_nothing_of_a_refused_command) {
  send("G28 X Y");
  send("G1 X500", false);
  send("G1 X1");
  go_to(1, 0);
  send("M400");
  EXPECT_EQ(missed(), 0U);
  EXPECT_NEAR(check.length_mm(), 1.0, 1e-9);
}

TEST_F(PointCheckTest, misses_a_prevented_extrusion_and_judges_the_lines_behind_it_from_there) {
  send("G28 X Y");
  begin("G1 X1 E5");
  check.reply(clock, "echo: cold extrusion prevented");
  end();
  go_to(1, 0);
  send("G1 X2 E6");
  go_to(160, 0, 0, 500);
  send("M400");
  EXPECT_EQ(reached(), 1U);
  EXPECT_EQ(missed(), 1U);
  EXPECT_THAT(check.judgement().missed_by_axis, ElementsAre(0, 0, 0, 1));
  EXPECT_EQ(check.judgement().list.at(0).axes[3].wanted_mm, 5);
}

TEST_F(PointCheckTest, understands_offsets_relative_moves_inches_and_flow) {
  send("G28");
  send("G92 X100 E3");
  send("G1 X101 E5");
  go_to(80, 0, 0, 1000);
  send("G91");
  send("G1 X1 Y2");
  go_to(2, 2);
  send("G20");
  send("G1 Y1");
  go_to(2, 27.4);
  send("G90");
  send("M83");
  send("G21");
  send("M221 S50");
  send("G1 E-3");
  go_to(position[0], position[1], 0, 250);
  send("M82");
  send("G92 E0");
  send("G1 E2");
  go_to(position[0], position[1], 0, 750);
  send("M400");
  EXPECT_EQ(reached(), 5U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, keeps_the_place_where_the_steps_per_millimetre_change) {
  send("G28");
  send("G1 X10");
  go_to(800, 0, 0, 0);
  send("M92 X100");
  send("G1 X11");
  go_to(900, 0, 0, 0);
  send("M400");
  EXPECT_EQ(reached(), 2U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, checks_moves_before_homing_from_where_the_machine_stands) {
  send("G91");
  send("G1 X1");
  for (int i = 0; i < 80; ++i) {
    ++clock;
    step(0, 1);
  }
  send("M400");
  EXPECT_EQ(reached(), 1U);
  EXPECT_LT(check.max_deviation_mm(), 1e-9);
}

TEST_F(PointCheckTest, lets_a_second_homing_do_what_it_wants_after_the_moves_before_it) {
  send("G28 X Y");
  send("G1 X10 Y10");
  begin("G28 X0 Y0");
  go_to(10, 10);
  go_to(-0.0125, 10);
  go_to(2, 10);
  go_to(0, 0);
  end();
  send("G1 X1");
  go_to(1, 0);
  send("M400");
  EXPECT_EQ(missed(), 0U);
  EXPECT_EQ(reached(), 2U);
  EXPECT_LT(check.max_deviation_mm(), 1.0 / 80);
}

TEST_F(PointCheckTest, follows_a_host_with_several_lines_in_flight_one_of_them_refused) {
  send("G28 X Y");
  begin("G1 X1");
  begin("G1 X500");
  begin("G1 X2");
  go_to(2, 0);  // before any of them is answered
  end();
  end(false);
  end();
  send("M400");
  EXPECT_EQ(reached(), 2U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, settles_at_m400_also_where_the_next_line_has_been_sent_before_its_end) {
  send("G28 X Y");
  begin("G1 X1");
  begin("M400");
  begin("G1 X2");
  end();
  go_to(1, 0);
  end();
  EXPECT_EQ(reached(), 1U);
  EXPECT_EQ(missed(), 0U);
  end();
  go_to(2, 0);
  send("M400");
  EXPECT_EQ(reached(), 2U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, does_not_miss_what_is_still_under_way) {
  send("G28 X Y");
  send("G1 X10");
  send("G1 X20");
  go_to(15, 0);
  EXPECT_EQ(reached(), 1U);
  EXPECT_EQ(missed(), 0U);
}

TEST_F(PointCheckTest, stays_right_over_more_points_than_it_keeps_in_mind) {
  send("G28 X Y");
  for (int i = 0; i < 5000; ++i) {
    send(i % 2 == 0 ? "G1 X1 Y1" : "G1 X0 Y1");
    // Every tenth line is left out, and the one behind it with it.
    if (i % 20 < 18) {
      go_to(i % 2 == 0 ? 1 : 0, 1);
    }
  }
  send("M400");
  EXPECT_EQ(reached() + missed(), 5000U);
  EXPECT_EQ(missed(), 250U);  // the second of each pair ends where the machine stands
}

}  // namespace
