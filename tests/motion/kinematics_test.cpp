// SPDX-License-Identifier: Apache-2.0
// The kinematics against floating point: both directions, reach, and the chords of lines.
#include <gmock/gmock.h>

#include "motion/kinematics/square_root.hpp"
#include "tests/motion/delta_machines.hpp"

namespace {

using motion::kinematics::CoreXy;
using motion::kinematics::Delta;
using motion::kinematics::Place;
using namespace motion_test;

TEST(square_root, is_the_nearest_whole_number) {
  Places random(1);
  for (int i = 0; i < 100'000; ++i) {
    const auto square =
        static_cast<std::uint64_t>(random.within(0, std::int64_t{1} << random.within(1, 61)));
    const auto root =
        static_cast<std::uint64_t>(std::llround(std::sqrt(static_cast<long double>(square))));
    ASSERT_EQ(motion::nearest_root(square), root) << square;
  }
  for (std::uint64_t root : {1ULL, 2ULL, 65'535ULL, 1'000'000'000ULL}) {
    EXPECT_EQ(motion::nearest_root(root * root + root), root);
    EXPECT_EQ(motion::nearest_root(root * root + root + 1), root + 1);
    EXPECT_EQ(motion::nearest_root(root * root), root);
  }
}

TEST(core_xy, is_exact_both_ways) {
  Places random(2);
  for (int i = 0; i < 100'000; ++i) {
    Place place;
    for (units::Position& axis : place) {
      axis = units::Position(units::Nanometers(random.within(-500'000'000, 500'000'000)),
                             static_cast<std::uint32_t>(random.within(0, 4'999) * 200));
    }
    const Place motors = CoreXy::motors_of(place);
    ASSERT_EQ(motors[0], place[0] + place[1]);
    ASSERT_EQ(motors[1] + place[1], place[0]);
    ASSERT_EQ(CoreXy::place_of(motors), place);
  }
}

TEST(delta, carriages_are_where_the_rods_hold_them) {
  Places random(3);
  for (const Delta::Parameters& each : deltas) {
    const Delta delta(each);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
      const Place place = random.reached_by(delta);
      const Place motors = delta.motors_of(place);
      for (std::size_t tower = 0; tower < 3; ++tower) {
        worst = std::max(worst, std::abs(mm(motors[tower]) - carriage(each, tower, mm(place))));
      }
    }
    EXPECT_LE(worst, 2 * nm);  // half by the root, half and more by the towers
  }
}

TEST(delta, the_way_back_from_the_carriages_leads_to_the_tool) {
  Places random(4);
  for (const Delta::Parameters& each : deltas) {
    const Delta delta(each);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
      const Place place = random.reached_by(delta);
      worst = std::max(worst, distance(mm(delta.place_of(delta.motors_of(place))), mm(place)));
    }
    EXPECT_LE(worst, 5 * nm);
  }
}

TEST(delta, within_reach_no_carriage_is_above_its_place_at_home_and_lines_stay_within) {
  Places random(5);
  for (const Delta::Parameters& each : deltas) {
    const Delta delta(each);
    EXPECT_TRUE(delta.reaches(delta.home().tool));
    const double most = carriage(each, 0, mm(delta.home().tool));
    for (int i = 0; i < 100'000; ++i) {
      const Place from = random.reached_by(delta), to = random.reached_by(delta);
      Place between;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        between[axis] =
            units::Nanometers((from[axis].whole().count() * 3 + to[axis].whole().count()) / 4);
      }
      ASSERT_TRUE(delta.reaches(between));
      for (std::size_t tower = 0; tower < 3; ++tower) {
        ASSERT_LE(carriage(each, tower, mm(between)), most + 2 * nm);
      }
    }
    const std::int64_t radius = each.printable_radius.count();
    EXPECT_FALSE(delta.reaches(at(radius + 1, 0, 0, 0)));
    EXPECT_FALSE(delta.reaches(at(radius * 8 / 10, radius * 8 / 10, 0, 0)));
    EXPECT_FALSE(delta.reaches(at(0, 0, each.height.count() + 1, 0)));
    EXPECT_FALSE(delta.reaches(at(radius, 0, each.height.count() - 1'000'000, 0)));
    EXPECT_FALSE(delta.reaches(at(4'000'000'000'000, 0, 0, 0)));
  }
}

// The tool while the carriages go evenly from one end of each chord to the other.
TEST(delta, a_line_in_chords_stays_within_a_hundredth_of_a_millimetre) {
  Places random(6);
  for (const Delta::Parameters& each : deltas) {
    const Delta delta(each);
    double worst = 0;
    std::uint64_t most_chords = 0;
    for (int i = 0; i < 4'000; ++i) {
      const Place from = random.reached_by(delta), to = random.reached_by(delta);
      motion::kinematics::Division chords;
      chords.begin(from, {.target = to, .feedrate = units::MicrometersPerSecond(50'000)},
                   delta.chords(from, to));
      most_chords = std::max<std::uint64_t>(most_chords, chords.left());
      Place begin = from;
      const Vector a = mm(from), b = mm(to);
      while (!chords.done()) {
        const Place end = chords.next().target;
        const Place low = delta.motors_of(begin), high = delta.motors_of(end);
        Place motors;
        for (std::size_t motor = 0; motor < 3; ++motor) {
          motors[motor] =
              units::Nanometers((low[motor].nearest().count() + high[motor].nearest().count()) / 2);
        }
        const Vector here = mm(delta.place_of(motors));
        const double length = distance(a, b);
        double along = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          along += (here[axis] - a[axis]) * (b[axis] - a[axis]) / length / length;
        }
        Vector foot{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          foot[axis] = a[axis] + along * (b[axis] - a[axis]);
        }
        worst = std::max(worst, distance(here, foot));
        begin = end;
      }
      ASSERT_EQ(begin, to);
    }
    std::printf("worst %.4f mm, at most %llu chords\n", worst,
                static_cast<unsigned long long>(most_chords));
    EXPECT_LE(worst, 0.01);
    EXPECT_GE(worst, 0.002);  // no more chords than needed
  }
}

}  // namespace
