// SPDX-License-Identifier: Apache-2.0
// The planner with motors that are not axes: exact ends, stops, reach, limits.
#include <gmock/gmock.h>

#include "motion/kinematics/path_limits.hpp"
#include "motion/planner.hpp"
#include "tests/motion/scara_machines.hpp"

namespace {

using motion::kinematics::Any;
using motion::kinematics::CoreXy;
using motion::kinematics::Delta;
using motion::kinematics::Place;
using namespace motion_test;

motion::Limits limits() {
  motion::Limits limits = motion_test::mendel();
  for (std::size_t i = 0; i < 3; ++i) {
    limits.axes[i] = motion_test::axis_limits(80'000, 0, 200, 3'000, 10'000);
  }
  return limits;
}

// Of what the machine reaches, Z at 20 mm.
Place middle_of(const Any& model) {
  const std::int64_t middle = model.curved_motors() == 2 ? 100'000'000 : 0;
  return at(middle, middle, 20'000'000, 0);
}

// Through the planner: the motors' steps are those of the last place, whatever led there.
TEST(kinematics, the_end_is_exact_after_100_000_random_short_moves) {
  const std::array<Any, 4> models{Any{}, Any(CoreXy::Parameters{}), Any(deltas[0]), Any(scaras[0])};
  for (const Any& model : models) {
    for (const bool relative : {false, true}) {
      Places random(7);
      motion::Planner planner(limits(), motion_test::timing(50'000'000), model);
      const Place start = middle_of(model);
      Place place = start;
      planner.set_position(place);
      units::PerAxis<std::int64_t> steps = planner.position_steps();
      units::Microseconds now{};
      for (int i = 0; i < 100'000; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::int64_t most = relative ? 20'000 : 3'000'000;
          const units::Position way(units::Nanometers(random.within(-most, most)),
                                    static_cast<std::uint32_t>(random.within(0, 4'999) * 200));
          const units::Position from = relative ? planner.position()[axis] : start[axis];
          place[axis] = from + way;
        }
        ASSERT_TRUE(planner.append(
            {.target = place, .feedrate = units::MicrometersPerSecond(100'000)}, now));
        planner.flush();
        now += units::Microseconds(60'000'000);
        while (const auto segment = planner.next_segment(now)) {
          if (!segment->continues_line) {
            for (std::size_t axis = 0; axis < 4; ++axis) steps[axis] += segment->steps[axis];
          }
          now += units::Microseconds(60'000'000);
        }
      }
      const Place motors = model.motors_of(place);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const long double exact = (static_cast<long double>(motors[axis].whole().count()) +
                                   motors[axis].femtometers() * 1e-6L) *
                                  80'000 / 1'000'000'000;
        EXPECT_EQ(steps[axis], std::llround(exact)) << axis;
        EXPECT_EQ(planner.position_steps()[axis], steps[axis]);
      }
    }
  }
}

TEST(kinematics, a_stop_leaves_the_place_that_the_motors_have) {
  for (const Any& model : {Any(CoreXy::Parameters{}), Any(deltas[0]), Any(scaras[0])}) {
    motion::Planner planner(limits(), motion_test::timing(50'000'000), model);
    Place place = middle_of(model);
    place[0] += units::Nanometers(10'123'456);
    place[1] += units::Nanometers(-7'654'321);
    place[3] = units::Nanometers(1'000'000);
    planner.set_position(place);
    const auto steps = planner.position_steps();
    planner.set_position_steps(steps);
    // Half a step of each of three motors; an arm's is 3.5 times as long at the tool.
    EXPECT_LE(distance(mm(planner.position()), mm(place)), 0.05);
    // A line of E alone moves no other motor.
    Place further = planner.position();
    further[3] += units::Nanometers(1'000'000);
    ASSERT_TRUE(
        planner.append({.target = further, .feedrate = units::MicrometersPerSecond(10'000)}, {}));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(planner.position_steps()[axis], steps[axis]);
    }
  }
}

TEST(kinematics, what_is_out_of_reach_is_refused_and_changes_nothing) {
  for (const Any& model : {Any(deltas[0]), Any(scaras[0])}) {
    motion::Planner planner(limits(), motion_test::timing(50'000'000), model);
    planner.set_position(middle_of(model));
    const auto steps = planner.position_steps();
    const auto accepted = planner.append({.target = at(86'000'000, -1'000'000, 0, 0),
                                          .feedrate = units::MicrometersPerSecond(10'000)},
                                         {});
    ASSERT_FALSE(accepted);
    EXPECT_EQ(accepted.error(), motion::Fault::target_out_of_reach);
    EXPECT_TRUE(planner.empty());
    EXPECT_EQ(planner.position_steps(), steps);
    EXPECT_EQ(planner.position(), middle_of(model));
  }
}

// Speed along X, Y and Z, and the carriages' acceleration by their speed and by the curvature.
TEST(kinematics, limits_of_axes_and_motors_hold_along_the_path) {
  Places random(8);
  const Delta delta(deltas[0]);
  const motion::Limits machine = limits();
  for (int i = 0; i < 20'000; ++i) {
    const Place from = random.reached_by(delta), to = random.reached_by(delta);
    const Vector a = mm(from), b = mm(to);
    const double length = distance(a, b);
    const double by_axes = motion::kinematics::speed_of_axes(machine, from, to).count() / 1000.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_LE(by_axes * std::abs(b[axis] - a[axis]) / length, 200.01);
    }
    const double speed =
        delta.speed_limit(from, to, machine.axes[0].max_acceleration).count() / 1000.0;
    for (const double part : {0.01, 0.5, 0.99}) {
      const double step = 0.1 / length;
      const auto place = [&](double where) {
        return Vector{a[0] + where * (b[0] - a[0]), a[1] + where * (b[1] - a[1]),
                      a[2] + where * (b[2] - a[2])};
      };
      for (std::size_t tower = 0; tower < 3; ++tower) {
        const double curvature = (carriage(deltas[0], tower, place(part + step)) -
                                  2 * carriage(deltas[0], tower, place(part)) +
                                  carriage(deltas[0], tower, place(part - step))) /
                                 0.01;
        ASSERT_LE(std::abs(curvature) * speed * speed, 3'000 * 1.001);
      }
    }
  }
}

}  // namespace
