// SPDX-License-Identifier: Apache-2.0
// The arms of a SCARA against floating point: both directions, reach, and the chords of lines.
#include <gmock/gmock.h>

#include "tests/motion/scara_machines.hpp"

namespace {

using motion::kinematics::Place;
using motion::kinematics::Scara;
using namespace motion_test;

TEST(scara, arms_hold_the_tool_with_the_elbow_on_its_side) {
  ScaraPlaces random(11);
  for (const Scara::Parameters& each : scaras) {
    const Scara model(each);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
      const Place place = random.reached_by(model);
      const Place motors = model.motors_of(place);
      const auto held = tool_of(each, mm(motors[0]), mm(motors[1]));
      worst = std::max(worst, std::hypot(held[0] - mm(place[0]), held[1] - mm(place[1])));
      const double elbow = std::sin(radians(mm(motors[0]) - mm(motors[1])));
      ASSERT_EQ(elbow > 0, each.elbow_left);
      for (const std::size_t arm : {0UZ, 1UZ}) {
        const double off = mm(motors[arm]) - direction(each, arm, mm(place));
        ASSERT_LE(std::abs(std::remainder(off, 360)), 1.5e-6);
        const double end_stop = length(each.end_stop[arm]);
        ASSERT_LE(mm(motors[arm]), end_stop + 10);
        ASSERT_GT(mm(motors[arm]), end_stop - 350);
      }
      ASSERT_EQ(motors[2], place[2]);
    }
    EXPECT_LE(worst, radians(1.5e-6) * (length(each.proximal) + length(each.distal)));
  }
}

TEST(scara, the_way_back_from_the_arms_leads_to_the_tool) {
  ScaraPlaces random(12);
  for (const Scara::Parameters& each : scaras) {
    const Scara model(each);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
      const Place place = random.reached_by(model);
      worst = std::max(worst, distance(mm(model.place_of(model.motors_of(place))), mm(place)));
    }
    std::printf("worst %.1f nm\n", worst / nm);
    EXPECT_LE(worst, 25 * nm);
  }
}

// Directions are whole turns apart where end stops are, and no line passes from one to the other.
TEST(scara, directions_change_as_little_as_the_tool_does) {
  ScaraPlaces random(13);
  for (const Scara::Parameters& each : scaras) {
    const Scara model(each);
    for (int i = 0; i < 20'000; ++i) {
      const auto [from, to] = random.line_of(model);
      const Place near = at(from[0].whole().count() + (to[0] - from[0]).whole().count() / 1000,
                            from[1].whole().count() + (to[1] - from[1]).whole().count() / 1000,
                            from[2].whole().count(), 0);
      const Place here = model.motors_of(from), there = model.motors_of(near);
      for (const std::size_t arm : {0UZ, 1UZ}) {
        ASSERT_LE(std::abs(mm(here[arm]) - mm(there[arm])), 3);
      }
    }
  }
}

TEST(scara, takes_targets_on_the_bed_and_between_the_circles) {
  ScaraPlaces random(14);
  for (const Scara::Parameters& each : scaras) {
    const Scara model(each);
    EXPECT_TRUE(model.straight_within(model.home().tool, model.home().tool));
    int refused = 0;
    const double slack = length(Scara::slack);
    for (int i = 0; i < 100'000; ++i) {
      const Place place = random.anywhere(each);
      const double margin = inside(each, mm(place));
      if (std::abs(margin) > 2 * nm) {
        ASSERT_EQ(model.straight_within(place, place), margin > 0);
      }
      if (std::abs(margin + slack) > 2 * nm) {
        ASSERT_EQ(model.reaches(place), margin > -slack);
      }
      refused += margin < 0 ? 1 : 0;
    }
    EXPECT_GT(refused, 1'000);
    const std::int64_t middle = each.width.count() / 2, end = each.width.count();
    for (const Place& outside :
         {at(-1, middle, 0, 0), at(end + 1, middle, 0, 0), at(middle, -1, 0, 0),
          at(middle, end + 1, 0, 0), at(middle, middle, each.height.count() + 1, 0)}) {
      EXPECT_FALSE(model.straight_within(outside, outside));
    }
    for (const std::int64_t far : {2'000'000'000LL, -4'000'000'000'000LL}) {
      EXPECT_FALSE(model.reaches(at(far, middle, 0, 0)));
      EXPECT_FALSE(model.reaches(at(middle, middle, far, 0)));
    }
  }
}

// Both ends may be between the circles, and the middle not.
TEST(scara, takes_a_line_only_if_all_of_it_is_within_reach) {
  ScaraPlaces random(15);
  for (const Scara::Parameters& each : scaras) {
    const Scara model(each);
    int refused = 0;
    for (int i = 0; i < 20'000; ++i) {
      const Place from = random.reached_by(model), to = random.reached_by(model);
      double least = 1e9;
      constexpr int samples = 500;
      for (int sample = 0; sample <= samples; ++sample) {
        least = std::min(least, inside(each, between(mm(from), mm(to), sample * 1.0 / samples)));
      }
      const bool taken = model.straight_within(from, to);
      ASSERT_EQ(model.straight_within(to, from), taken);
      // Between two samples the distance from the shoulder is less by (length / 1000)^2 / 2r.
      if (taken) {
        ASSERT_GE(least, -2 * nm);
      } else {
        ASSERT_LE(least, 0.01);
      }
      refused += taken ? 0 : 1;
    }
    EXPECT_GT(refused, 10);
    EXPECT_LT(refused, 10'000);
  }
  const Scara model(scaras[0]);
  EXPECT_FALSE(model.straight_within(at(20'000'000, 0, 0, 0), at(180'000'000, 0, 0, 0)));
  EXPECT_TRUE(
      model.straight_within(at(20'000'000, 30'000'000, 0, 0), at(180'000'000, 30'000'000, 0, 0)));
}

// The bounds that a chord's end must keep leave room for its rounding.
TEST(scara, takes_the_ends_of_chords_of_each_line_that_it_takes) {
  const Scara model(scaras[0]);
  const std::int64_t radius = scaras[0].inner_radius.count();
  // Along a tangent of the inner circle, to the nanometre.
  const std::int64_t y = scaras[0].shoulder_y.count() + radius;
  const Place from = at(20'000'000, y, 0, 0), to = at(180'000'001, y, 0, 0);
  ASSERT_TRUE(model.straight_within(from, to));
  EXPECT_FALSE(model.straight_within(at(20'000'000, y - 10, 0, 0), at(180'000'000, y - 10, 0, 0)));
  motion::kinematics::Division chords;
  chords.begin(from, {.target = to, .feedrate = units::MicrometersPerSecond(50'000)},
               model.chords(from, to));
  EXPECT_GT(chords.left(), 10U);
  while (!chords.done()) ASSERT_TRUE(model.reaches(chords.next().target));
  // A stop leaves the tool at rounded steps: from there a line leads away.
  const Place inside = at(100'000'000, y - 20'000, 0, 0);
  EXPECT_TRUE(model.straight_within(inside, at(100'000'000, y + 1'000'000, 0, 0)));
  EXPECT_FALSE(model.straight_within(inside, inside));
}

// The tool while the arms turn evenly from one end of each chord to the other.
TEST(scara, a_line_in_chords_stays_within_a_hundredth_of_a_millimetre) {
  ScaraPlaces random(16);
  for (const Scara::Parameters& each : scaras) {
    const Scara model(each);
    double worst = 0, worst_of_many = 0;
    std::uint64_t most_chords = 0;
    for (int i = 0; i < 4'000; ++i) {
      const auto [from, to] = random.line_of(model);
      const bool many = model.chords(from, to) > 20;
      motion::kinematics::Division chords;
      chords.begin(from, {.target = to, .feedrate = units::MicrometersPerSecond(50'000)},
                   model.chords(from, to));
      most_chords = std::max<std::uint64_t>(most_chords, chords.left());
      const Vector a = mm(from), b = mm(to);
      const double way = std::hypot(b[0] - a[0], b[1] - a[1]);
      Place begin = from;
      while (!chords.done()) {
        const Place end = chords.next().target;
        const Place low = model.motors_of(begin), high = model.motors_of(end);
        for (const double part : {0.25, 0.5, 0.75}) {
          const auto here = tool_of(each, mm(low[0]) + part * (mm(high[0]) - mm(low[0])),
                                    mm(low[1]) + part * (mm(high[1]) - mm(low[1])));
          const double aside = (here[0] - a[0]) * (b[1] - a[1]) - (here[1] - a[1]) * (b[0] - a[0]);
          worst = std::max(worst, std::abs(aside) / way);
          if (many) worst_of_many = std::max(worst_of_many, std::abs(aside) / way);
        }
        begin = end;
      }
      ASSERT_EQ(begin, to);
    }
    std::printf("worst %.4f mm, at most %llu chords\n", worst,
                static_cast<unsigned long long>(most_chords));
    EXPECT_LE(worst, 0.01);
    EXPECT_GE(worst_of_many, 0.006);  // no more chords than needed
  }
}

// By the curvature of the arms' ways.
TEST(scara, speed_is_limited_so_that_no_arm_exceeds_its_acceleration) {
  ScaraPlaces random(17);
  for (const Scara::Parameters& each : scaras) {
    const Scara model(each);
    double most = 0;
    for (int i = 0; i < 20'000; ++i) {
      const auto [from, to] = random.line_of(model);
      const Vector a = mm(from), b = mm(to);
      const double way = distance(a, b), step = 0.1 / way;
      const auto limit = units::MicrometersPerSecondSquared(1'500'000);
      const double speed = model.speed_limit(from, to, limit).count() / 1000.0;
      for (const double part : {0.01, 0.5, 0.99}) {
        for (const std::size_t arm : {0UZ, 1UZ}) {
          const auto at_part = [&](double where) {
            return direction(each, arm, between(a, b, where));
          };
          const double first = std::remainder(at_part(part + step) - at_part(part), 360);
          const double second = std::remainder(at_part(part) - at_part(part - step), 360);
          const double acceleration = std::abs(first - second) / 0.01 * speed * speed;
          ASSERT_LE(acceleration, 1'500 * 1.002);
          most = std::max(most, acceleration);
        }
      }
    }
    EXPECT_GE(most, 500);  // no slower than needed
  }
}

// From where an end stop switches, a motor goes back to where it is at home.
TEST(scara, home_is_behind_the_end_stops) {
  for (const Scara::Parameters& each : scaras) {
    const motion::kinematics::Home home = Scara(each).home();
    const Vector tool = mm(home.tool);
    const auto held = tool_of(each, length(each.end_stop[0]) + length(home.behind_end_stop[0]),
                              length(each.end_stop[1]) + length(home.behind_end_stop[1]));
    EXPECT_NEAR(held[0], length(each.width) / 2, 30 * nm);
    EXPECT_NEAR(held[1], length(each.depth) / 2, 30 * nm);
    EXPECT_NEAR(tool[2], 150, nm);
    for (const units::Nanometers& behind : home.behind_end_stop) {
      EXPECT_LE(behind, units::Nanometers(0));
    }
  }
}

}  // namespace
