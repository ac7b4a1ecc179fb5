// SPDX-License-Identifier: Apache-2.0
// The path is thinned, and stays what the edges drew.
#include "sim/report/tool_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/report/requested_path.hpp"

namespace {

constexpr sim::ClockRate rate(4'000'000);
constexpr double step_mm = 1.0 / 80;

class ToolPathTest : public testing::Test {
 protected:
  void step(std::size_t axis, int direction) {
    position[axis] += direction;
    path.stepped({now, axis, direction, position[axis]});
  }
  // A line in x and y by Bresenham, a tick each 1000 clocks, with `pushed` steps of the extruder.
  void line(std::int64_t dx, std::int64_t dy, std::int64_t pushed) {
    const std::int64_t ticks = std::max(std::abs(dx), std::abs(dy));
    const auto due = [ticks](std::int64_t count, std::int64_t tick) {
      return (2 * std::abs(count) * tick + ticks) / (2 * ticks) >
             (2 * std::abs(count) * (tick - 1) + ticks) / (2 * ticks);
    };
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
      now += 1000;
      if (due(dx, tick)) step(0, dx > 0 ? 1 : -1);
      if (due(dy, tick)) step(1, dy > 0 ? 1 : -1);
      if (due(pushed, tick)) step(3, pushed > 0 ? 1 : -1);
    }
  }
  // The farthest of `x`, `y` (mm) from the path.
  double distance_from_path(double x, double y) const {
    double nearest = 1e9;
    const auto points = path.points();
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double ax = points[i - 1].x, ay = points[i - 1].y;
      const double dx = points[i].x - ax, dy = points[i].y - ay;
      const double squared = dx * dx + dy * dy;
      const double part =
          squared > 0 ? std::clamp(((x - ax) * dx + (y - ay) * dy) / squared, 0.0, 1.0) : 0;
      nearest = std::min(nearest, std::hypot(x - ax - part * dx, y - ay - part * dy));
    }
    return nearest;
  }

  sim::Clock now = 1000;
  std::array<std::int64_t, 4> position{};
  report::ToolPath path{rate, {80, 80, 2560, 500}, {0, 0, 0, 0}};
};

TEST_F(ToolPathTest, makes_of_a_staircase_the_line_that_it_was) {
  line(4000, 1234, 200);
  const auto points = path.points();
  // A line, and the ends of it before the first and after the last step of the extruder.
  ASSERT_LE(points.size(), 4U);
  EXPECT_FLOAT_EQ(points.back().x, 50);
  EXPECT_FLOAT_EQ(points.back().y, 15.425F);
  double extruded = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    extruded += points[i].extruding ? points[i].x - points[i - 1].x : 0;
  }
  EXPECT_NEAR(extruded, 50, 0.3);
  EXPECT_NEAR(points.back().seconds, rate.seconds(now), 1e-9);
}

TEST_F(ToolPathTest, stays_within_a_step_of_every_edge_of_a_curve) {
  std::vector<std::pair<double, double>> edges;
  for (int i = 1; i <= 2000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 2000;
    const auto x = std::llround(800 * std::sin(angle)),
               y = std::llround(800 - 800 * std::cos(angle));
    line(x - position[0], y - position[1], i % 5 == 0 ? 1 : 0);
    edges.emplace_back(step_mm * static_cast<double>(position[0]),
                       step_mm * static_cast<double>(position[1]));
  }
  EXPECT_LT(path.points().size(), edges.size() / 4);
  for (std::size_t i = 0; i < edges.size(); i += 7) {
    ASSERT_LE(distance_from_path(edges[i].first, edges[i].second),
              report::ToolPath::tolerance_steps * step_mm + 1e-6);
  }
}

TEST_F(ToolPathTest, thins_a_long_print_as_it_goes) {
  for (int i = 0; i < 20; ++i) {
    line(4000, 0, 200);
    line(-4000, 1, -1);
  }
  const auto points = path.points();
  EXPECT_LT(points.size(), 200U);
  std::size_t corners = 0;
  for (const report::ToolPoint& point : points) corners += point.x == 50;
  EXPECT_GE(corners, 20U);
}

TEST_F(ToolPathTest, knows_travel_from_extrusion) {
  line(800, 0, 40);
  line(0, 800, -40);
  line(800, 0, 0);
  line(0, -400, 20);
  double extruded = 0, travelled = 0;
  const auto points = path.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double way = std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    (points[i].extruding ? extruded : travelled) += way;
  }
  EXPECT_NEAR(extruded, 15, 0.6);
  EXPECT_NEAR(travelled, 20, 0.6);
}

TEST_F(ToolPathTest, takes_a_short_way_with_the_filament_drawn_back_for_travel) {
  const auto pull = [this](int direction) {
    for (int i = 0; i < 100; ++i) {
      now += 1000;
      step(3, direction);
    }
  };
  line(800, 0, 40);
  pull(-1);
  line(0, 48, 0);
  pull(1);
  line(-800, 0, 40);
  double travelled = 0;
  const auto points = path.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    travelled += points[i].extruding ? 0 : points[i].y - points[i - 1].y;
  }
  EXPECT_NEAR(travelled, 0.6, 1e-6);
}

TEST_F(ToolPathTest, remembers_how_long_the_nozzle_stood) {
  line(80, 0, 0);
  const double arrived = rate.seconds(now);
  now += rate.clocks(2);
  line(80, 0, 0);
  const auto points = path.points();
  std::size_t at = 0;
  while (at + 1 < points.size() && points[at].x != 1) ++at;
  ASSERT_LT(at + 1, points.size());
  EXPECT_EQ(points[at + 1].x, 1);
  EXPECT_NEAR(points[at].seconds, arrived, 1e-6);
  EXPECT_NEAR(points[at + 1].seconds, arrived + 2, 0.001);
}

TEST_F(ToolPathTest, begins_where_the_axes_are_homed) {
  line(-123, 55, 0);
  EXPECT_TRUE(path.homed({true, true, true}));
  line(80, 0, 0);
  const auto points = path.points();
  EXPECT_FLOAT_EQ(points.front().x, -123 * static_cast<float>(step_mm));
  EXPECT_FALSE(path.homed({true, false, false}));
  EXPECT_EQ(path.points().size(), points.size());
}

TEST(ToolPath, leaves_out_what_lies_on_a_line_and_keeps_corners_and_changes) {
  std::vector<report::ToolPoint> points{{0, 0, 0, false, 0}};
  for (int i = 1; i <= 100; ++i) points.push_back({static_cast<float>(i), 0, 0, i > 50, 0});
  points.push_back({100, 50, 0, true, 0});
  const auto kept = report::simplified(points, 0.01);
  ASSERT_EQ(kept.size(), 4U);
  EXPECT_EQ(kept[1].x, 50);
  EXPECT_FALSE(kept[1].extruding);
  EXPECT_EQ(kept[2].x, 100);
}

TEST(RequestedPath, goes_on_from_where_the_nozzle_is_after_a_refused_line) {
  report::RequestedPath path(rate);
  path.command_acknowledged(4000, 1, "G1 X10 Y5", true);
  path.command_acknowledged(8000, 2, "G1 X500", false);
  path.command_acknowledged(8000, 3, "M105", true);
  path.command_acknowledged(12000, 4, "G1 X20 E1", true);
  const auto& lines = path.lines();
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_FALSE(lines[1].executed);
  EXPECT_EQ(lines[1].to[0], 500);
  EXPECT_EQ(lines[2].from[0], 10);
  EXPECT_EQ(lines[2].file_line, 4U);
  EXPECT_TRUE(lines[2].extrudes);
  EXPECT_FALSE(lines[0].extrudes);
  EXPECT_DOUBLE_EQ(lines[2].seconds, 0.003);
}

}  // namespace
