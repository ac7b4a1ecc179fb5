// SPDX-License-Identifier: Apache-2.0
// Deltas as M665 and M666 may make them: whatever is accepted moves exactly, the rest is refused.
#include <gmock/gmock.h>

#include <string>

#include "motion/kinematics/delta_settings.hpp"
#include "motion/planner.hpp"
#include "tests/motion/delta_machines.hpp"

namespace {

using motion::kinematics::Any;
using motion::kinematics::fault_of;
using motion::kinematics::place_towers;
using namespace motion_test;
using testing::HasSubstr;

// In floating point, from the numbers of M665 alone.
double carriage_of(const Delta::Parameters& delta, std::size_t tower, const Vector& tool) {
  constexpr std::array<double, 3> degrees{210, 330, 90};
  const double angle = (degrees[tower] + delta.angle_trim[tower] * 1e-6) * std::numbers::pi / 180;
  const double radius = static_cast<double>(delta.radius.count()) * nm;
  const double rod = static_cast<double>((delta.rod + delta.rod_trim[tower]).count()) * nm;
  const double x = tool[0] - radius * std::cos(angle), y = tool[1] - radius * std::sin(angle);
  return tool[2] + std::sqrt(rod * rod - x * x - y * y);
}

// One that is accepted, often at the ends of the ranges.
Delta::Parameters random_delta(Places& random) {
  const auto length = [&](std::int64_t least_mm, std::int64_t most_mm) {
    return units::Nanometers(random.within(least_mm * 1'000'000, most_mm * 1'000'000));
  };
  while (true) {
    Delta::Parameters delta{.rod = length(100, 1'000),
                            .radius = length(50, 600),
                            .height = length(100, 1'000),
                            .printable_radius = length(30, 500)};
    for (std::size_t i = 0; i < 3; ++i) {
      const bool extreme = random.within(0, 3) == 0;
      const std::int64_t most = 10'000'000;
      const std::int64_t trim = extreme ? most * random.within(-1, 1) : random.within(-most, most);
      delta.angle_trim[i] = static_cast<std::int32_t>(trim);
      delta.rod_trim[i] = units::Nanometers(extreme ? most * random.within(-1, 1)
                                                    : random.within(-most, most) / 10);
    }
    place_towers(delta);
    if (fault_of(delta).empty()) return delta;
  }
}

TEST(delta_settings, place_carriages_where_the_rods_hold_them_and_find_the_tool_again) {
  Places random(1);
  double worst = 0, worst_back = 0;
  for (int machine = 0; machine < 1'000; ++machine) {
    const Delta::Parameters parameters = random_delta(random);
    const Delta delta(parameters);
    for (int i = 0; i < 100; ++i) {
      const Place place = random.reached_by(delta);
      const Place motors = delta.motors_of(place);
      for (std::size_t tower = 0; tower < 3; ++tower) {
        worst = std::max(worst,
                         std::abs(mm(motors[tower]) - carriage_of(parameters, tower, mm(place))));
      }
      worst_back = std::max(worst_back, distance(mm(delta.place_of(motors)), mm(place)));
    }
  }
  std::printf("carriages %.1f nm, tool %.1f nm\n", worst / nm, worst_back / nm);
  EXPECT_LE(worst, 4 * nm);
  EXPECT_LE(worst_back, 5 * nm);
}

// So no carriage drives into its end stop; the cone of reach is convex.
TEST(delta_settings, keep_carriages_below_their_place_at_home) {
  Places random(2);
  for (int machine = 0; machine < 1'000; ++machine) {
    const Delta::Parameters parameters = random_delta(random);
    const Delta delta(parameters);
    ASSERT_TRUE(delta.reaches(delta.home().tool));
    EXPECT_EQ(delta.home().tool[2], parameters.height);
    EXPECT_FALSE(delta.reaches(at(0, 0, parameters.height.count() + 1, 0)));
    for (int i = 0; i < 100; ++i) {
      const Place place = random.reached_by(delta);
      for (std::size_t tower = 0; tower < 3; ++tower) {
        ASSERT_LE(carriage_of(parameters, tower, mm(place)),
                  carriage_of(parameters, tower, mm(delta.home().tool)) + 4 * nm);
      }
    }
  }
}

// How far the tool is from its line in the middle of each chord.
double worst_deviation(const Delta& delta, const Place& from, const Place& to) {
  motion::kinematics::Division chords;
  chords.begin(from, {.target = to, .feedrate = units::MicrometersPerSecond(50'000)},
               delta.chords(from, to));
  const Vector a = mm(from), b = mm(to);
  const double length = distance(a, b);
  double worst = 0;
  for (Place begin = from; !chords.done();) {
    const Place end = chords.next().target;
    const Place low = delta.motors_of(begin), high = delta.motors_of(end);
    Place motors;
    for (std::size_t motor = 0; motor < 3; ++motor) {
      motors[motor] =
          units::Nanometers((low[motor].nearest().count() + high[motor].nearest().count()) / 2);
    }
    const Vector here = mm(delta.place_of(motors));
    double along = 0;
    for (std::size_t i = 0; i < 3; ++i) along += (here[i] - a[i]) * (b[i] - a[i]) / length / length;
    Vector foot{};
    for (std::size_t i = 0; i < 3; ++i) foot[i] = a[i] + along * (b[i] - a[i]);
    worst = std::max(worst, distance(here, foot));
    begin = end;
  }
  return worst;
}

TEST(delta_settings, keep_chords_within_a_hundredth_of_a_millimetre) {
  Places random(3);
  double worst = 0;
  for (int machine = 0; machine < 1'000; ++machine) {
    const Delta delta(random_delta(random));
    for (int i = 0; i < 10; ++i) {
      const Place from = random.reached_by(delta), to = random.reached_by(delta);
      worst = std::max(worst, worst_deviation(delta, from, to));
    }
    ASSERT_LE(worst, 0.01) << "rod " << delta.parameters().rod.count() << ", radius "
                           << delta.parameters().radius.count() << ", bed "
                           << delta.parameters().printable_radius.count();
  }
  std::printf("tool %.4f mm\n", worst);
}

TEST(delta_settings, leave_the_end_exact_after_100_000_random_short_moves) {
  Places random(4);
  motion::Limits limits = motion_test::mendel();
  for (std::size_t i = 0; i < 3; ++i) limits.axes[i] = axis_limits(80'000, 0, 200, 3'000, 10'000);
  motion::Planner planner(limits, motion_test::timing(50'000'000), Any(deltas[0]));
  Place place = at(0, 0, 50'000'000, 0);
  planner.set_position(place);
  units::Microseconds now{};
  constexpr int machines = 100, moves = 1'000;
  for (int machine = 0; machine < machines; ++machine) {
    const Delta delta(random_delta(random));
    planner.set_kinematics(Any(delta.parameters()));
    planner.set_position(place = at(0, 0, 50'000'000, 0));
    units::PerAxis<std::int64_t> steps = planner.position_steps();
    for (int i = 0; i < moves; ++i) {
      Place target = place;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        target[axis] += units::Position(units::Nanometers(random.within(-50'000, 50'000)),
                                        static_cast<std::uint32_t>(random.within(0, 999'999)));
      }
      ASSERT_TRUE(planner.append(
          {.target = target, .feedrate = units::MicrometersPerSecond(100'000)}, now));
      place = target;
      planner.flush();
      now += units::Microseconds(60'000'000);
      while (const auto segment = planner.next_segment(now)) {
        if (!segment->continues_line) {
          for (std::size_t axis = 0; axis < 4; ++axis) steps[axis] += segment->steps[axis];
        }
        now += units::Microseconds(60'000'000);
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double exact = carriage_of(delta.parameters(), axis, mm(place)) * 80;
      EXPECT_NEAR(static_cast<double>(steps[axis]), exact, 0.501) << machine;
    }
  }
}

TEST(delta_settings, refuse_what_cannot_be_moved_exactly) {
  const auto refused = [](const auto& change, const char* reason) {
    Delta::Parameters delta = deltas[0];
    change(delta);
    EXPECT_THAT(std::string(fault_of(delta)), HasSubstr(reason));
  };
  EXPECT_EQ(fault_of(deltas[0]), "");
  const auto length = [](double mm) { return units::Nanometers(std::llround(mm * 1e6)); };
  refused([&](auto& delta) { delta.rod = length(199); }, "flat");
  refused([&](auto& delta) { delta.rod_trim[1] = length(-10.1); }, "A, B or C");
  refused([&](auto& delta) { delta.rod = length(1'000.1); }, "L not within");
  refused([&](auto& delta) { delta.rod = length(340); }, "upright");
  refused([&](auto& delta) { delta.radius = length(85); }, "R not above");
  refused([&](auto& delta) { delta.radius = length(0.5); }, "R not within");
  refused([&](auto& delta) { delta.radius = length(200); }, "flat");
  refused([&](auto& delta) { delta.height = length(0); }, "H not within");
  refused([&](auto& delta) { delta.angle_trim[2] = 10'000'001; }, "degrees");
  refused([&](auto& delta) { delta.angle_trim[0] = -10'000'001; }, "degrees");
  refused([&](auto& delta) { delta.end_stop_offset[0] = length(0.01); }, "<= 0");
  refused([&](auto& delta) { delta.end_stop_offset[2] = length(-10.01); }, "-10");
}

}  // namespace
