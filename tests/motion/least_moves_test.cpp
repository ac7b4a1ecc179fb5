// SPDX-License-Identifier: Apache-2.0
// Moves of less than a nanometre around the position where rounding makes a step due: a line of
// almost no length still has its step, at a finite rate.
#include <gmock/gmock.h>

#include <random>
#include <vector>

#include "motion/planner.hpp"
#include "tests/motion/machine.hpp"
#include "tests/motion/print_run.hpp"

namespace {

using motion::LineMove;
using motion_test::mendel;
using motion_test::PrintRun;
using motion_test::RunResult;
using units::MicrometersPerSecond;
using units::Nanometers;
using units::Position;

constexpr std::int64_t femtometers_per_nanometer = Position::femtometers_per_nanometer;
constexpr std::int64_t hundredth_nm = femtometers_per_nanometer / 100;
constexpr MicrometersPerSecond feedrate{10'000};
// A line of one step takes less, even from rest.
constexpr double longest_step_seconds = 0.002;

Position femtometers(std::int64_t count) {
  std::int64_t whole = count / femtometers_per_nanometer;
  std::int64_t rest = count % femtometers_per_nanometer;
  if (rest < 0) {
    rest += femtometers_per_nanometer;
    --whole;
  }
  return {Nanometers(whole), static_cast<std::uint32_t>(rest)};
}

// Where half a step is reached and the first step is due.
std::int64_t edge(std::size_t axis) {
  return std::int64_t{1'000'000'000'000'000} / mendel().axes[axis].steps_per_meter.count() / 2;
}

// Relative moves, collected as the targets that they lead to.
class Moves {
 public:
  void move(std::size_t axis, std::int64_t distance) {
    at_[axis] += distance;
    units::PerAxis<Position> target;
    for (std::size_t i = 0; i < target.size(); ++i) target[i] = femtometers(at_[i]);
    moves_.push_back({.target = target, .feedrate = feedrate});
  }
  // The axis moves as part of the next move.
  void also_move(std::size_t axis, std::int64_t distance) { at_[axis] += distance; }

  const std::vector<LineMove>& list() const { return moves_; }

  units::PerAxis<std::int64_t> exact_steps() const {
    units::PerAxis<std::int64_t> steps;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      steps[i] = motion_test::exact_steps(femtometers(at_[i]), mendel().axes[i].steps_per_meter);
    }
    return steps;
  }

 private:
  units::PerAxis<std::int64_t> at_{};
  std::vector<LineMove> moves_;
};

void expect_exact(const Moves& moves, std::uint64_t lines) {
  PrintRun run(mendel(), {});
  const RunResult result = run.run(moves.list());
  EXPECT_EQ(result.final_steps, moves.exact_steps());
  EXPECT_EQ(result.lines, lines);
  EXPECT_EQ(result.wrong_line_ends, 0u);
  EXPECT_EQ(result.underruns, 0u);
  EXPECT_LE(result.worst_speed_excess, 1e-5);
  EXPECT_LE(result.worst_acceleration_excess, 1e-5);
  EXPECT_LE(result.seconds, static_cast<double>(lines) * longest_step_seconds);
}

class LeastMoves : public testing::TestWithParam<std::size_t> {};

TEST_P(LeastMoves, step_back_and_forth_over_the_edge) {
  const std::size_t axis = GetParam();
  Moves moves;
  moves.move(axis, edge(axis));
  for (int i = 0; i < 50; ++i) {
    moves.move(axis, -hundredth_nm);
    moves.move(axis, hundredth_nm);
  }
  expect_exact(moves, 101);
}

TEST_P(LeastMoves, add_up_to_a_step_in_each_direction) {
  const std::size_t axis = GetParam();
  Moves moves;
  moves.move(axis, edge(axis) - 3 * femtometers_per_nanometer);
  for (int i = 0; i < 600; ++i) moves.move(axis, hundredth_nm);
  for (int i = 0; i < 600; ++i) moves.move(axis, -hundredth_nm);
  expect_exact(moves, 2);
}

TEST_P(LeastMoves, step_during_a_move_of_another_axis) {
  const std::size_t axis = GetParam();
  const std::size_t other = (axis + 1) % units::axis_count;
  Moves moves;
  moves.move(axis, edge(axis));
  for (int i = 0; i < 50; ++i) {
    moves.also_move(axis, i % 2 == 0 ? -hundredth_nm : hundredth_nm);
    moves.move(other, hundredth_nm * (1 + i % 60));
  }
  expect_exact(moves, 51);
}

INSTANTIATE_TEST_SUITE_P(axes, LeastMoves, testing::Range<std::size_t>(0, units::axis_count));

class RandomLeastMoves : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomLeastMoves, of_all_axes_are_exact) {
  std::mt19937_64 random(GetParam());
  Moves moves;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) moves.also_move(axis, edge(axis));
  moves.move(0, 0);
  units::PerAxis<std::int64_t> offset{};  // from the edge, less than a nanometre
  std::uint64_t lines = 1;
  units::PerAxis<std::int64_t> steps = moves.exact_steps();
  for (int i = 0; i < 500; ++i) {
    for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
      if (random() % 3 != 0) continue;
      const std::int64_t next = (static_cast<std::int64_t>(random() % 200) - 100) * hundredth_nm;
      moves.also_move(axis, next - offset[axis]);
      offset[axis] = next;
    }
    moves.move(0, 0);
    if (moves.exact_steps() != steps) ++lines;
    steps = moves.exact_steps();
  }
  EXPECT_GT(lines, 200u);
  expect_exact(moves, lines);
}

INSTANTIATE_TEST_SUITE_P(seeds, RandomLeastMoves, testing::Range(1u, 9u));

}  // namespace
