// SPDX-License-Identifier: Apache-2.0
// Chords of arcs against the circle in floating point: every end on it, every middle near it, all
// of it, in its direction, the last end exact.
#include "motion/arc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>

namespace motion {
namespace {

using units::Axis;
using units::index_of;
using units::Nanometers;
// With what begin() said.
struct BegunArc : Arc {
  explicit BegunArc(const ArcRequest& request) : begun(begin(request)) {}
  std::expected<void, Fault> begun;
};

using Place = units::PerAxis<units::Position>;

constexpr double turn = 2 * std::numbers::pi;

units::Position nm(double count) { return Nanometers(std::llround(count)); }
double nm(const units::Position& position) {
  return static_cast<double>(position.whole().count()) + position.femtometers() * 1e-6;
}

// A circle in the plane, by angles from its centre.
struct Circle {
  Plane plane{};
  double first{}, second{}, radius{};  // of the centre, nm

  void put(Place& place, double angle, double distance) const {
    place[index_of(axes_of(plane)[0])] = nm(first + distance * std::cos(angle));
    place[index_of(axes_of(plane)[1])] = nm(second + distance * std::sin(angle));
  }
  double x(const Place& place) const { return nm(place[index_of(axes_of(plane)[0])]) - first; }
  double y(const Place& place) const { return nm(place[index_of(axes_of(plane)[1])]) - second; }
  double distance(const Place& place) const { return std::hypot(x(place), y(place)); }
  double angle(const Place& place) const { return std::atan2(y(place), x(place)); }
};

PlaneVector from_to(const Place& start, const Circle& circle) {
  const auto axes = axes_of(circle.plane);
  const auto way = [&](Axis axis, double centre) {
    return Nanometers(std::llround(centre - nm(start[index_of(axis)])));
  };
  return {way(axes[0], circle.first), way(axes[1], circle.second)};
}

struct Wanted {
  Circle circle;
  bool clockwise{};
  double from{}, sweep{};  // radians, sweep positive
  double mismatch{};  // nm, of the radius at the end
};
ArcRequest request_of(const Wanted& wanted, const Place& others) {
  ArcRequest request{.plane = wanted.circle.plane,
                     .clockwise = wanted.clockwise,
                     .start = others,
                     .target = others,
                     .centre = {}};
  const double to = wanted.from + (wanted.clockwise ? -wanted.sweep : wanted.sweep);
  wanted.circle.put(request.start, wanted.from, wanted.circle.radius);
  if (wanted.sweep < turn) {
    wanted.circle.put(request.target, to, wanted.circle.radius + wanted.mismatch);
  } else {
    request.target = request.start;
  }
  request.centre = from_to(request.start, wanted.circle);
  return request;
}

// Rounding is allowed for, by 0.1 um and a part of the radius.
void check(const Wanted& wanted, ArcRequest request) {
  BegunArc arc(request);
  ASSERT_TRUE(arc.begun) << describe(arc.begun.error());
  const Circle& circle = wanted.circle;
  const double slack = 150 + circle.radius * 1e-8;
  const double spread = std::abs(wanted.mismatch);
  const auto chords = static_cast<double>(arc.chords());
  Place before = request.start;
  double swept = 0;
  for (double made = 1; !arc.done(); ++made) {
    ASSERT_LE(made, chords);
    const Place end = arc.next();
    ASSERT_NEAR(circle.distance(end), circle.radius, slack + spread);
    Place middle = before;
    for (std::size_t i = 0; i < middle.size(); ++i) {
      middle[i] = nm((nm(before[i]) + nm(end[i])) / 2);
    }
    ASSERT_LE(circle.radius - circle.distance(middle), 5'000 + slack + spread);
    double way = circle.angle(end) - circle.angle(before);
    if (wanted.clockwise) way = -way;
    while (way < 0) way += turn;
    swept += way;
    // The others go evenly; each part of the arc is as large as the others.
    ASSERT_NEAR(swept, wanted.sweep * made / chords, 2e-8 + (2 * slack + spread) / circle.radius);
    for (std::size_t i = 0; i < end.size(); ++i) {
      if (i == index_of(axes_of(circle.plane)[0]) || i == index_of(axes_of(circle.plane)[1])) {
        continue;
      }
      const double whole = nm(request.target[i]) - nm(request.start[i]);
      ASSERT_NEAR(nm(end[i]) - nm(request.start[i]), whole * made / chords, 2);
    }
    for (const Axis axis : axes_of(circle.plane)) {
      ASSERT_GE(nm(end[index_of(axis)]), nm(arc.lowest()[index_of(axis)]));
      ASSERT_LT(nm(end[index_of(axis)]), nm(arc.highest()[index_of(axis)]) + 1);
    }
    before = end;
  }
  EXPECT_EQ(before, request.target);
  EXPECT_NEAR(swept, wanted.sweep, 2e-8 + (2 * slack + spread) / circle.radius);
}

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

// Radii from 1 um to 10 m, anywhere, in any plane, with Z and E or what else is not of the plane.
TEST(arc, of_any_size_lies_on_its_circle_and_ends_at_its_target) {
  std::mt19937_64 random(from_environment("ARC_SEED", 1));
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const std::uint64_t count = from_environment("ARC_COUNT", 100'000);
  for (std::uint64_t i = 0; i < count; ++i) {
    Wanted wanted;
    wanted.circle = {.plane = static_cast<Plane>(random() % 3),
                     .first = std::round(between(-3e8, 3e8)),
                     .second = std::round(between(-3e8, 3e8)),
                     .radius = std::pow(10, between(3, 9.999))};
    wanted.clockwise = random() % 2 == 0;
    wanted.from = between(0, turn);
    wanted.sweep = random() % 4 == 0 ? turn : between(0.01, turn - 0.01);
    if (wanted.sweep < turn && random() % 2 == 0) {
      const double allowed = std::clamp(wanted.circle.radius / 1000, 20e3, 500e3);
      wanted.mismatch = std::min(allowed, wanted.circle.radius / 3) * between(-0.98, 0.98);
    }
    Place others;
    for (auto& place : others) place = nm(between(-1e8, 1e8));
    ArcRequest request = request_of(wanted, others);
    for (std::size_t axis = 0; axis < others.size(); ++axis) {
      if (axis == index_of(axes_of(wanted.circle.plane)[0]) ||
          axis == index_of(axes_of(wanted.circle.plane)[1])) {
        continue;
      }
      request.target[axis] = units::Position(nm(between(-1e9, 1e9)).whole(),
                                             static_cast<std::uint32_t>(random() % 1'000'000));
    }
    check(wanted, request);
    if (HasFatalFailure() || HasNonfatalFailure()) {
      FAIL() << "arc " << i << ": plane " << static_cast<int>(wanted.circle.plane) << ", radius "
             << wanted.circle.radius << ", from " << wanted.from << ", sweep " << wanted.sweep
             << (wanted.clockwise ? " clockwise" : "") << ", mismatch " << wanted.mismatch;
    }
  }
}

TEST(arc, has_as_few_chords_as_the_deviation_permits) {
  for (const double radius : {5e3, 1e5, 1e6, 2e7, 1e9, 1e10}) {
    Wanted wanted;
    wanted.circle.radius = radius;
    wanted.sweep = turn;
    const BegunArc arc(request_of(wanted, {}));
    ASSERT_TRUE(arc.begun);
    const double widest = 2 * std::acos(std::max(1 - 5'000 / radius, std::cos(0.5)));
    EXPECT_GE(arc.chords(), turn / widest * 0.99) << radius;
    EXPECT_LE(arc.chords(), turn / widest * 1.05 + 1) << radius;
  }
}

TEST(arc, begins_and_ends_on_a_quarter_of_its_circle) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (const int quarters : {1, 2, 3, 4}) {
      for (const bool clockwise : {false, true}) {
        Wanted wanted;
        wanted.circle = {.radius = 5e6};
        wanted.clockwise = clockwise;
        wanted.from = quarter * turn / 4;
        wanted.sweep = quarters * turn / 4;
        check(wanted, request_of(wanted, {}));
        if (HasFailure()) FAIL() << quarter << " " << quarters << " " << clockwise;
      }
    }
  }
}

Place place(double x, double y) { return {nm(x * 1e6), nm(y * 1e6), nm(0), nm(0)}; }
PlaneVector offset(double i, double j) { return {nm(i * 1e6).whole(), nm(j * 1e6).whole()}; }

Fault refusal(const ArcRequest& request) {
  const auto begun = BegunArc(request).begun;
  EXPECT_FALSE(begun);
  return begun ? Fault::queue_full : begun.error();
}

TEST(arc, is_refused_where_its_end_is_off_the_circle) {
  ArcRequest request{.start = place(0, 0), .target = place(20, 0), .centre = offset(10.02, 0)};
  EXPECT_EQ(refusal(request), Fault::arc_end_off_circle);
  request.centre = offset(10.009, 0);  // 0.018 mm between the radii
  EXPECT_TRUE(BegunArc(request).begun);
  // A thousandth of the radius, but not more than half a millimetre.
  request = {.start = place(0, 0), .target = place(200.18, 0), .centre = offset(100, 0)};
  EXPECT_FALSE(BegunArc(request).begun);
  request.target = place(200.09, 0);
  EXPECT_TRUE(BegunArc(request).begun);
  request = {.start = place(0, 0), .target = place(4000.6, 0), .centre = offset(2000, 0)};
  EXPECT_EQ(refusal(request), Fault::arc_end_off_circle);
  request.target = place(1e9, 0);
  EXPECT_EQ(refusal(request), Fault::arc_end_off_circle);
}

TEST(arc, is_refused_without_a_radius_or_with_one_above_ten_metres) {
  EXPECT_EQ(refusal({.start = place(1, 1), .target = place(2, 1), .centre = {}}),
            Fault::arc_without_radius);
  EXPECT_EQ(refusal({.start = place(0, 0), .target = place(0, 0), .centre = offset(10'000.1, 0)}),
            Fault::arc_too_large);
  EXPECT_EQ(refusal({.start = place(0, 0), .target = place(0, 0), .centre = offset(9e3, 9e3)}),
            Fault::arc_too_large);
  EXPECT_EQ(refusal({.start = place(0, 0), .target = place(0, 0), .centre = offset(4e9, 4e9)}),
            Fault::arc_too_large);
}

// Half a circle above the line from 0 to 20: with the clock.
TEST(arc, reaches_the_outermost_points_of_its_circle_that_it_passes) {
  const BegunArc arc(
      {.clockwise = true, .start = place(0, 0), .target = place(20, 0), .centre = offset(10, 0)});
  ASSERT_TRUE(arc.begun);
  EXPECT_NEAR(nm(arc.highest()[1]), 10e6, 120);
  EXPECT_EQ(nm(arc.lowest()[1]), 0);
}

TEST(arc, is_as_fast_as_the_acceleration_towards_its_centre_permits) {
  const BegunArc arc({.start = place(0, 0), .target = place(0, 0), .centre = offset(4, 3)});
  ASSERT_TRUE(arc.begun);
  using Acceleration = units::MicrometersPerSecondSquared;
  Limits limits;
  for (AxisLimits& axis : limits.axes) axis.max_acceleration = Acceleration(2'000'000);
  EXPECT_NEAR(arc.speed_limit(limits, Acceleration(9'000'000)).count(), 100'000, 2);
  EXPECT_NEAR(arc.speed_limit(limits, Acceleration(500'000)).count(), 50'000, 2);
  limits.of(Axis::y).max_acceleration = Acceleration(180'000);
  EXPECT_NEAR(arc.speed_limit(limits, Acceleration(500'000)).count(), 30'000, 2);
}

}  // namespace
}  // namespace motion
