// SPDX-License-Identifier: Apache-2.0
// The centre of an arc that is given by its radius.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "motion/arc.hpp"

namespace motion {
namespace {

using units::Nanometers;

constexpr double turn = 2 * std::numbers::pi;

units::Position nm(double count) { return Nanometers(std::llround(count)); }
units::PerAxis<units::Position> place(double x, double y) {
  return {nm(x * 1e6), nm(y * 1e6), nm(0), nm(0)};
}

// The centre is as far from both ends as the radius says, on the side that its sign says.
TEST(arc, finds_the_centre_for_a_radius) {
  std::mt19937_64 random(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 100'000; ++i) {
    const double radius = std::pow(10, between(4, 9.999));
    const double sweep = between(0.001, turn - 0.001);
    const bool clockwise = random() % 2 == 0;
    const double from = between(0, turn), to = from + (clockwise ? -sweep : sweep);
    ArcRequest request{.clockwise = clockwise, .target = {}, .centre = {}};
    const double dx = std::round(radius * (std::cos(to) - std::cos(from)));
    const double dy = std::round(radius * (std::sin(to) - std::sin(from)));
    request.target = {nm(dx), nm(dy), nm(0), nm(0)};
    const auto set = set_centre(request, nm(sweep > turn / 2 ? -radius : radius).whole());
    ASSERT_TRUE(set) << radius << " " << sweep;
    const auto x = static_cast<double>(request.centre[0].count());
    const auto y = static_cast<double>(request.centre[1].count());
    const double slack = 80 + radius * 1e-8;
    ASSERT_NEAR(std::hypot(x, y), radius, slack) << radius << " " << sweep;
    ASSERT_NEAR(std::hypot(dx - x, dy - y), radius, slack) << radius << " " << sweep;
    // The centre is left of the way counter-clockwise where the arc is less than half a circle.
    // Near half a circle the radius, rounded to a nanometre, says too little of it.
    const double from_half = std::abs(sweep - turn / 2);
    if (radius * from_half * from_half > 2e3 && radius * std::min(sweep, turn - sweep) > 1e5) {
      ASSERT_EQ(dx * y - dy * x > 0, clockwise == (sweep > turn / 2)) << radius << " " << sweep;
    }
  }
}

// Half a circle says so exactly: a nanometre more would move its centre by 0.1 mm.
TEST(arc, has_its_centre_in_the_middle_where_the_radius_is_half_the_way) {
  for (const double radius : {0.5, 10.0, 10.005, 123.457, 400.0}) {
    ArcRequest request{.target = place(-2 * radius, 0), .centre = {}};
    ASSERT_TRUE(set_centre(request, nm(radius * 1e6).whole()));
    EXPECT_EQ(request.centre[0], nm(-radius * 1e6).whole());
    EXPECT_EQ(request.centre[1], Nanometers(0));
  }
}

TEST(arc, with_a_radius_is_refused_where_no_circle_passes_through_both_ends) {
  const auto refused = [](double distance_mm, double radius_mm) {
    ArcRequest request{.target = place(distance_mm, 0), .centre = {}};
    const auto set = set_centre(request, nm(radius_mm * 1e6).whole());
    return set ? Fault::queue_full : set.error();
  };
  EXPECT_EQ(refused(10.1, 5), Fault::arc_ends_too_far_apart);
  EXPECT_EQ(refused(10.02, 5), Fault::queue_full);  // not refused
  EXPECT_EQ(refused(0, 5), Fault::arc_without_radius);
  EXPECT_EQ(refused(1, 0), Fault::arc_without_radius);
  EXPECT_EQ(refused(1, -11e3), Fault::arc_too_large);
  EXPECT_EQ(refused(1e9, 5), Fault::arc_too_large);
}

}  // namespace
}  // namespace motion
