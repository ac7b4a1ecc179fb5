// SPDX-License-Identifier: Apache-2.0
// The judge of the steps: circles end where they begin, and lines after them may be on their way.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/sim/point_check_fixture.hpp"

namespace {

using report::Steps;
using testing::ElementsAre;

struct Circle {
  double x{}, y{};  // where it begins, mm
  double i{}, j{};
  double turns = 1;  // counter-clockwise
  std::string text() const { return fmt::format("G{} I{:.5f} J{:.5f}", turns < 0 ? 2 : 3, i, j); }
};

class PointCheckCircles : public tests::PointCheckTest {
 protected:
  PointCheckCircles() {
    send("G28 X Y");
    send("M83");
  }
  void start_of(const Circle& circle) {
    send(fmt::format("G1 X{:.5f} Y{:.5f}", circle.x, circle.y));
    go_to(circle.x, circle.y);
  }
  // Each axis at its nearest step, from one part of the way to another.
  void turn(const Circle& circle, double from = 0, double to = 1) {
    const double radius = std::hypot(circle.i, circle.j);
    const double start = std::atan2(-circle.j, -circle.i);
    constexpr int samples = 20'000;
    for (int n = static_cast<int>(from * samples); n <= static_cast<int>(to * samples); ++n) {
      const double angle = start + 2 * std::numbers::pi * circle.turns * n / samples;
      const bool end = n == samples;
      go_to(end ? circle.x : circle.x + circle.i + radius * std::cos(angle),
            end ? circle.y : circle.y + circle.j + radius * std::sin(angle));
    }
  }
  void twitch(std::size_t axis, int steps = 1) {
    for (const int direction : {1, -1}) {
      for (int i = 0; i < steps; ++i) {
        ++clock;
        step(axis, direction);
      }
    }
  }
  void line(double x, double y) {
    send(fmt::format("G1 X{:.5f} Y{:.5f}", x, y));
    go_to(x, y);
  }
  static constexpr Circle small{10, 10, 0.07087, 0.07055};
  static constexpr double half_step = 0.00625;
};

TEST_F(PointCheckCircles, may_be_followed_by_a_line_that_lies_on_them) {
  start_of(small);
  send(small.text());
  send("G1 X10.00625");
  send("G1 X12");
  turn(small);
  go_to(10 + half_step, 10);
  go_to(12, 10);
  // A chord to the other side.
  const Circle large{12, 10, 3, 0, -1};
  send(large.text());
  send("G1 X15 Y13");
  send("G1 X15 Y20");
  turn(large);
  go_to(15, 13);
  go_to(15, 20);
  send("M400");
  EXPECT_EQ(missed(), 0u);
  EXPECT_EQ(reached(), 7u);
  EXPECT_THAT(unasked(), ElementsAre(0, 0, 0, 0, 0));
}

TEST_F(PointCheckCircles, are_good_wherever_they_begin) {
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (int n = 0; n < 600; ++n) {
    const double angle = between(0, 7), radius = std::array{0.01, 0.03, 0.1, 1., 7.}[random() % 5];
    Circle circle{std::round(between(20, 40) * 1e5) / 1e5, std::round(between(20, 40) * 1e5) / 1e5,
                  std::round(radius * std::cos(angle) * 1e5) / 1e5,
                  std::round(radius * std::sin(angle) * 1e5) / 1e5, random() % 2 == 0 ? 1. : -1.};
    start_of(circle);
    const double x = circle.x + static_cast<double>(random() % 3) * half_step - half_step;
    const double y = circle.y + static_cast<double>(random() % 3) * half_step - half_step;
    send(circle.text());
    if (n % 3 == 0) send(circle.text());
    std::vector<std::array<double, 2>> ends{
        {x, y}, {x + half_step / 2, y}, {x + half_step, y + half_step}};
    if (n % 2 == 0) ends.push_back({x + 3, y});
    // Before they are made, or one by one.
    const bool ahead = n % 4 < 2;
    for (const auto& end : ends) {
      if (ahead) send(fmt::format("G1 X{:.5f} Y{:.5f}", end[0], end[1]));
    }
    turn(circle);
    if (n % 3 == 0) turn(circle);
    for (const auto& end : ends) ahead ? go_to(end[0], end[1]) : line(end[0], end[1]);
    if (n % 5 == 0) send("M400");
    ASSERT_EQ(missed(), 0u) << n;
    ASSERT_THAT(unasked(), ElementsAre(0, 0, 0, 0, 0))
        << n << " " << circle.x << " " << circle.y << " " << circle.text();
  }
}

TEST_F(PointCheckCircles, have_no_place_for_a_step_that_no_line_asks_for) {
  std::int64_t made = 0;
  for (const double part : {0., 0.02, 0.3, 0.5, 0.98, 1.}) {
    start_of(small);
    send(small.text());
    send("G1 X10.00625");
    send("G1 X12");
    turn(small, 0, part);
    twitch(0);
    made += 2;
    turn(small, part);
    go_to(10 + half_step, 10);
    go_to(12, 10);
    EXPECT_EQ(missed(), 0u) << part;
    EXPECT_EQ(unasked()[0], made) << part;
  }
  for (const int after : {0, 1, 2}) {
    start_of(small);
    send(small.text());
    turn(small);
    if (after == 0) twitch(0);
    line(10 + half_step, 10);
    if (after == 1) twitch(0);
    line(12, 10);
    if (after == 2) twitch(0);
    send("M400");
    made += 2;
    EXPECT_EQ(unasked()[0], made) << after;
  }
  EXPECT_EQ(unasked()[1], 0);
}

TEST_F(PointCheckCircles, are_missed_where_they_are_left_out) {
  start_of(small);
  send(small.text());
  line(10 + half_step, 10);
  line(12, 10);
  send("M400");
  EXPECT_EQ(missed(), 1u);
  EXPECT_EQ(reached(), 3u);
  const Circle printed{12, 10, 2, 0};
  send(printed.text() + " E1");
  go_to(position[0], position[1], 0, 500);
  line(15, 10);
  send("M400");
  EXPECT_EQ(missed(), 2u);
}

TEST_F(PointCheckCircles, count_as_often_as_they_are_made) {
  const Circle circle{12, 10, 2, 0};
  start_of(circle);
  send(circle.text());
  send(circle.text());
  turn(circle);
  line(15, 10);
  send("M400");
  EXPECT_EQ(missed(), 1u);
  start_of(circle);
  send(circle.text());
  turn(circle);
  turn(circle);
  line(15, 10);
  send("M400");
  EXPECT_EQ(missed(), 1u);
  EXPECT_THAT(unasked(), ElementsAre(640, 640, 0, 0, 0));
}

TEST_F(PointCheckCircles, do_not_set_steps_that_are_left_out_against_others) {
  start_of(small);
  send(small.text());
  turn(small);
  send("G1 X20 Y10");
  send("G1 X11 Y11");
  go_to(15, 10);
  go_to(11, 11);
  line(11, 12);
  twitch(0, 5);
  line(11, 14);
  send("M400");
  EXPECT_EQ(missed(), 1u);
  EXPECT_THAT(unasked(), ElementsAre(10, 0, 0, 0, 0));
}

TEST_F(PointCheckCircles, do_not_hide_steps_after_the_last_line) {
  send("G1 X10 Y10");
  go_to(10, 10);
  twitch(0, 7);
  EXPECT_EQ(unasked()[0], 14);
  send("M400");
  EXPECT_EQ(unasked()[0], 14);
  twitch(1, 3);
  send("M400");
  EXPECT_THAT(unasked(), ElementsAre(14, 6, 0, 0, 0));
}

}  // namespace
