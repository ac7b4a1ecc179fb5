// SPDX-License-Identifier: Apache-2.0
// The kinematics against floating point: both directions, reach, and the chords of lines.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "motion/kinematics/any.hpp"
#include "motion/kinematics/path_limits.hpp"
#include "motion/kinematics/square_root.hpp"
#include "motion/planner.hpp"
#include "tests/motion/machine.hpp"

namespace {

using motion::kinematics::Any;
using motion::kinematics::CoreXy;
using motion::kinematics::Delta;
using motion::kinematics::Place;
using motion_test::at;

constexpr double nm = 1e-6;  // in mm
using Vector = std::array<double, 3>;

double mm(const units::Position& position) {
  return static_cast<double>(position.whole().count()) * nm + position.femtometers() * 1e-12;
}
Vector mm(const Place& place) { return {mm(place[0]), mm(place[1]), mm(place[2])}; }
double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Delta::Parameters parameters(std::int64_t rod_mm, std::int64_t radius_mm, std::int64_t printable) {
  constexpr std::int64_t per_mm = 1'000'000;
  Delta::Parameters result{.rod = units::Nanometers(rod_mm * per_mm),
                           .radius = units::Nanometers(radius_mm * per_mm),
                           .height = units::Nanometers(250 * per_mm),
                           .printable_radius = units::Nanometers(printable * per_mm)};
  Delta::place_towers(result);
  return result;
}

const std::array<Delta::Parameters, 3> deltas{parameters(250, 105, 85), parameters(217, 98, 80),
                                              parameters(400, 200, 170)};

// By the geometry alone: the carriage's height, with towers at 210, 330 and 90 degrees.
double carriage(const Delta::Parameters& delta, std::size_t tower, const Vector& tool) {
  constexpr std::array<double, 3> degrees{210, 330, 90};
  const double angle = degrees[tower] * std::numbers::pi / 180;
  const double radius = static_cast<double>(delta.radius.count()) * nm;
  const double rod = static_cast<double>(delta.rod.count()) * nm;
  const double x = tool[0] - radius * std::cos(angle), y = tool[1] - radius * std::sin(angle);
  return tool[2] + std::sqrt(rod * rod - x * x - y * y);
}

class Places {
 public:
  explicit Places(std::uint64_t seed) : random_(seed) {}
  std::int64_t within(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  Place reached_by(const Delta& delta) {
    const std::int64_t most = delta.parameters().printable_radius.count();
    while (true) {
      const Place place = at(within(-most, most), within(-most, most),
                             within(0, delta.parameters().height.count()), 0);
      if (delta.reaches(place)) return place;
    }
  }

 private:
  std::mt19937_64 random_;
};

TEST(square_root, is_the_nearest_whole_number) {
  Places random(1);
  for (int i = 0; i < 100'000; ++i) {
    const auto square =
        static_cast<std::uint64_t>(random.within(0, std::int64_t{1} << random.within(1, 61)));
    const auto root = static_cast<std::uint64_t>(
        std::llround(std::sqrt(static_cast<long double>(square))));
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
        between[axis] = units::Nanometers(
            (from[axis].whole().count() * 3 + to[axis].whole().count()) / 4);
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
                   delta.chords(from, to, units::MicrometersPerSecond(50'000)));
      most_chords = std::max<std::uint64_t>(most_chords, chords.left());
      Place begin = from;
      const Vector a = mm(from), b = mm(to);
      while (!chords.done()) {
        const Place end = chords.next().target;
        const Place low = delta.motors_of(begin), high = delta.motors_of(end);
        Place motors;
        for (std::size_t motor = 0; motor < 3; ++motor) {
          motors[motor] = units::Nanometers(
              (low[motor].nearest().count() + high[motor].nearest().count()) / 2);
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

TEST(delta, m665_places_the_towers_as_the_description_does) {
  Delta::Parameters trimmed = deltas[0];
  trimmed.angle_trim = {1'500'000, -750'000, 0};
  Delta::place_towers(trimmed);
  const double radius = static_cast<double>(trimmed.radius.count());
  const std::array<double, 3> degrees{211.5, 329.25, 90};
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = degrees[i] * std::numbers::pi / 180;
    EXPECT_NEAR(static_cast<double>(trimmed.towers[i].x.count()), radius * std::cos(angle), 1.01);
    EXPECT_NEAR(static_cast<double>(trimmed.towers[i].y.count()), radius * std::sin(angle), 1.01);
  }
}

motion::Limits limits() {
  motion::Limits limits = motion_test::mendel();
  for (std::size_t i = 0; i < 3; ++i) {
    limits.axes[i] = motion_test::axis_limits(80'000, 0, 200, 3'000, 10'000);
  }
  return limits;
}

// Through the planner: the motors' steps are those of the last place, whatever led there.
TEST(kinematics, the_end_is_exact_after_100_000_random_short_moves) {
  const std::array<Any, 3> models{Any{}, Any(CoreXy::Parameters{}), Any(deltas[0])};
  for (const Any& model : models) {
    for (const bool relative : {false, true}) {
      Places random(7);
      motion::Planner planner(limits(), motion_test::timing(50'000'000), model);
      Place place = at(0, 0, 20'000'000, 0);
      planner.set_position(place);
      units::PerAxis<std::int64_t> steps = planner.position_steps();
      units::Microseconds now{};
      for (int i = 0; i < 100'000; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::int64_t most = relative ? 20'000 : 3'000'000;
          const units::Position way(units::Nanometers(random.within(-most, most)),
                                    static_cast<std::uint32_t>(random.within(0, 4'999) * 200));
          const units::Position from =
              relative ? planner.position()[axis] : units::Position(units::Nanometers(5'000'000));
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

TEST(kinematics, a_stop_tells_the_place_from_the_motors) {
  for (const Any& model : {Any(CoreXy::Parameters{}), Any(deltas[0])}) {
    motion::Planner planner(limits(), motion_test::timing(50'000'000), model);
    const Place place = at(10'123'456, -7'654'321, 30'000'000, 1'000'000);
    planner.set_position(place);
    const auto steps = planner.position_steps();
    planner.set_position_steps(steps);
    // Half a step of each of three motors.
    EXPECT_LE(distance(mm(planner.position()), mm(place)), 0.03);
    // A line of E alone moves no other motor.
    Place further = planner.position();
    further[3] += units::Nanometers(1'000'000);
    ASSERT_TRUE(planner.append(
        {.target = further, .feedrate = units::MicrometersPerSecond(10'000)}, {}));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(planner.position_steps()[axis], steps[axis]);
    }
  }
}

TEST(kinematics, what_is_out_of_reach_is_refused_and_changes_nothing) {
  motion::Planner planner(limits(), motion_test::timing(50'000'000), Any(deltas[0]));
  const auto accepted = planner.append(
      {.target = at(86'000'000, 0, 0, 0), .feedrate = units::MicrometersPerSecond(10'000)}, {});
  ASSERT_FALSE(accepted);
  EXPECT_EQ(accepted.error(), motion::Fault::target_out_of_reach);
  EXPECT_TRUE(planner.empty());
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
