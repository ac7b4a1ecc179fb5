// SPDX-License-Identifier: Apache-2.0
// What holds of every plan: limits, symmetry, the use of look-ahead, exact ends. From random moves.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "motion/profile.hpp"
#include "tests/motion/machine.hpp"
#include "tests/motion/print_run.hpp"
#include "tests/motion/segment_run.hpp"

namespace {

using motion::LineMove;
using motion_test::at;
using motion_test::run_segments;
using motion_test::SegmentRunResult;

constexpr std::uint32_t clock_hz = 50'000'000;

motion::Limits machine(std::int64_t deviation_nm) {
  motion::Limits limits = motion_test::mendel();
  limits.junction_deviation = units::Nanometers(deviation_nm);
  return limits;
}

class RandomPath {
 public:
  explicit RandomPath(std::uint64_t seed) : random_(seed) {}

  std::int64_t within(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }

  // Long and short lines, hops of Z, retractions, curves of short lines.
  std::vector<LineMove> moves(std::size_t count, std::int64_t least_nm, std::int64_t most_nm) {
    std::vector<LineMove> moves;
    double course = 0;
    std::int64_t length = most_nm;
    auto speed = static_cast<std::int32_t>(within(5'000, 250'000));
    const bool curve = within(0, 2) == 0;
    while (moves.size() < count) {
      if (within(0, 3) == 0) speed = static_cast<std::int32_t>(within(5'000, 250'000));
      if (!curve || within(0, 9) == 0) course = static_cast<double>(within(0, 6'283)) / 1000;
      course += static_cast<double>(within(-100, 100)) / 1000;
      if (!curve || moves.empty()) length = within(least_nm, most_nm);
      const auto kind = within(0, 19);
      if (kind == 0) {
        place_[2] += within(-1'000'000, 1'000'000);
      } else if (kind == 1) {
        place_[3] += within(-2'000'000, 2'000'000);
      } else {
        place_[0] += std::llround(std::cos(course) * static_cast<double>(length));
        place_[1] += std::llround(std::sin(course) * static_cast<double>(length));
        if (kind > 8) place_[3] += length / 20;
      }
      moves.push_back({.target = at(place_[0], place_[1], place_[2], place_[3]),
                       .feedrate = units::MicrometersPerSecond(speed)});
    }
    return moves;
  }

 private:
  std::mt19937_64 random_;
  std::array<std::int64_t, 4> place_{};
};

TEST(plan_properties, no_limit_is_exceeded_in_100_000_random_sequences) {
  double speed = -1, acceleration = -1, jump = -1;
  for (std::uint64_t seed = 1; seed <= 100'000; ++seed) {
    RandomPath path(seed);
    const bool by_deviation = seed % 2 == 0;
    motion::Limits limits = machine(by_deviation ? path.within(1'000, 100'000) : 0);
    limits.min_cruise_percent = seed % 3 == 0 ? 50 : 0;
    const std::int64_t least = seed % 5 == 0 ? 20'000 : 500'000;
    const SegmentRunResult run = run_segments(limits, path.moves(12, least, 20'000'000), clock_hz);
    speed = std::max(speed, run.worst_speed);
    acceleration = std::max(acceleration, run.worst_acceleration);
    if (!by_deviation) jump = std::max(jump, run.worst_jump);
    ASSERT_LE(speed, 1e-4) << seed;
    ASSERT_LE(acceleration, 1e-4) << seed;
    ASSERT_LE(jump, 1e-4) << seed;
  }
  std::printf("worst: speed %+.1e, acceleration %+.1e, jump %+.1e\n", speed, acceleration, jump);
  // The limits are used.
  EXPECT_GE(speed, -1e-3);
  EXPECT_GE(acceleration, -1e-3);
}

// Where braking takes longer than lines are, also at a start with classic jerk and in corners.
TEST(plan_properties, no_acceleration_is_exceeded_however_low_it_is) {
  double worst = -1;
  for (std::uint64_t seed = 1; seed <= 10'000; ++seed) {
    RandomPath path(seed);
    motion::Limits limits = machine(seed % 4 == 0 ? path.within(1'000, 100'000) : 0);
    for (motion::AxisLimits& axis : limits.axes) {
      axis.max_acceleration = units::MicrometersPerSecondSquared(
          static_cast<std::int32_t>(path.within(1'000, 100'000)));
    }
    const auto count = static_cast<std::size_t>(path.within(1, 8));
    const SegmentRunResult run =
        run_segments(limits, path.moves(count, 500'000, 2'000'000), clock_hz);
    worst = std::max(worst, run.worst_acceleration);
    ASSERT_LE(worst, 1e-4) << seed;
  }
  EXPECT_GE(worst, -1e-3);
}

// Two lines of X and Y at an angle: the speed in the corner by the two circles, in floating point.
TEST(plan_properties, corners_are_as_fast_as_the_junction_deviation_permits) {
  constexpr double deviation_mm = 0.02, acceleration = 1'500, speed = 150;
  for (int degrees = 2; degrees < 179; ++degrees) {
    for (const double length : {0.4, 3.0, 30.0}) {
      const double turn = degrees * 3.14159265358979 / 180;
      const auto nm = [&](double mm) { return std::llround(mm * 1e6); };
      const std::vector<LineMove> moves{
          {.target = at(nm(30), 0, 0, 0), .feedrate = units::MicrometersPerSecond(150'000)},
          {.target = at(nm(30 + length * std::cos(turn)), nm(length * std::sin(turn)), 0, 0),
           .feedrate = units::MicrometersPerSecond(150'000)}};
      const SegmentRunResult run = run_segments(machine(nm(deviation_mm)), moves, clock_hz);
      ASSERT_EQ(run.lines.size(), 2u);
      const double ticks = run.lines[1].line_ticks;
      const double corner = run.speeds[1] * length / ticks;
      const double half = std::cos(turn / 2);
      const double circle = acceleration * deviation_mm * half / (1 - half);
      const double curve = acceleration * length / 2 * half / std::sin(turn / 2);
      // It brakes for the end of the second line, and is no slower than in the middle of a tick.
      const double end = 2 * acceleration * length;
      const double least = acceleration * length / ticks;
      const double square = std::max(std::min({circle, curve, end, speed * speed}), least);
      EXPECT_NEAR(corner / std::sqrt(square), 1, 0.01) << degrees << " degrees, " << length;
    }
  }
}

TEST(plan_properties, a_path_takes_as_long_backwards) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    RandomPath path(seed);
    std::vector<LineMove> forward = path.moves(20, 1'000'000, 10'000'000);
    std::vector<LineMove> backward;
    for (std::size_t i = forward.size() - 1; i > 0; --i) {
      backward.push_back({.target = forward[i - 1].target, .feedrate = forward[i].feedrate});
    }
    // The first move brings both to where they begin, and waits.
    const auto seconds = [](const units::PerAxis<units::Position>& begin,
                            const std::vector<LineMove>& moves) {
      std::vector<LineMove> shifted = moves;
      for (LineMove& move : shifted) {
        for (std::size_t i = 0; i < units::axis_count; ++i) {
          move.target[i] = move.target[i] - begin[i];
        }
      }
      return run_segments(machine(20'000), shifted, clock_hz).seconds;
    };
    const auto from_first =
        seconds(forward.front().target, std::vector<LineMove>(forward.begin() + 1, forward.end()));
    const auto from_last = seconds(forward.back().target, backward);
    EXPECT_NEAR(from_first / from_last, 1, 2e-3) << seed;
  }
}

TEST(plan_properties, more_look_ahead_is_never_slower) {
  double gained = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const auto moves = RandomPath(seed).moves(200, 100'000, 2'000'000);
    double before = 1e9;
    for (const std::size_t lines : {std::size_t{2}, std::size_t{4}, std::size_t{8}, std::size_t{16},
                                    motion::Planner::capacity}) {
      const double seconds =
          run_segments(machine(seed % 2 == 0 ? 10'000 : 0), moves, clock_hz, lines).seconds;
      EXPECT_LE(seconds, before * 1.0005) << seed << ", " << lines << " lines";
      gained = std::max(gained, before < 1e8 ? before / seconds - 1 : 0);
      before = seconds;
    }
  }
  EXPECT_GT(gained, 0.05);
}

TEST(plan_properties, the_end_is_exact_after_100_000_short_moves) {
  for (const std::int64_t reach_nm : {3'000, 40'000}) {
    RandomPath random(static_cast<std::uint64_t>(reach_nm));
    motion::Limits limits = machine(10'000);
    limits.of(units::Axis::x).steps_per_meter = units::StepsPerMeter(62'745);
    std::vector<LineMove> moves;
    units::PerAxis<units::Position> place{};
    for (int i = 0; i < 100'000; ++i) {
      for (units::Position& axis : place) {
        axis += units::Position(units::Nanometers(random.within(-reach_nm, reach_nm)),
                                static_cast<std::uint32_t>(random.within(0, 999'999)));
      }
      moves.push_back({.target = place, .feedrate = units::MicrometersPerSecond(60'000)});
    }
    const SegmentRunResult run = run_segments(limits, moves, clock_hz);
    for (std::size_t i = 0; i < units::axis_count; ++i) {
      EXPECT_EQ(run.steps[i], motion_test::exact_steps(place[i], limits.axes[i].steps_per_meter));
    }
  }
}

}  // namespace
