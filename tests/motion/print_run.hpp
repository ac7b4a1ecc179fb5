// SPDX-License-Identifier: Apache-2.0
// Drives a planner and the step model together as the firmware does, and checks every tick and
// every change of segment against the moves that were requested and the limits of the machine.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "motion/planner.hpp"
#include "tests/motion/machine.hpp"
#include "tests/motion/step_model.hpp"

namespace motion_test {

// What a slow processor needs, in clocks; it then appends one line a pass.
struct ProcessorTimes {
  std::uint64_t append{};  // from the line's arrival into the ring
  std::uint64_t hand_over{};  // a line's first segment; the others take a tenth
  std::uint64_t pass{};  // everything else
};

struct RunOptions {
  std::uint32_t clock_hz{4'000'000};
  std::size_t queue_depth{16};
  double lines_per_second{0};  // that the host supplies; 0: as many as fit
  double refill_seconds{0.001};
  std::optional<ProcessorTimes> processor{};
  units::Microseconds least_line_time{};
};

// What the run has seen; the worst of each excess over what is allowed, 0 or less where kept.
struct RunResult {
  double seconds{};  // from the first to the last clock of motion
  std::uint64_t lines{};
  std::uint64_t segments{};
  std::uint64_t underruns{};
  std::uint64_t rests{};  // times that motion came to rest
  std::uint64_t wrong_line_ends{};  // lines whose last tick left an axis off its target
  double worst_deviation_steps{};  // of any axis at any tick from where the exact line is then
  double worst_distance_steps{};  // of X and Y together from the exact line, at any tick
  double worst_speed_excess{};  // as a part of the limit
  double worst_acceleration_excess{};
  double worst_jump_excess_mm_s{};  // change of an axis' speed beyond its jerk
  double worst_rate_mismatch{};  // between the phases of one line, as a part of the rate
  double highest_speed_mm_s{};  // of X and Y together
  std::vector<double> speeds_mm_s{};  // the same, with which each line begins
  units::PerAxis<std::int64_t> final_steps{};
};

// Target / 10^9 * steps per metre, halves away from 0, in arithmetic of its own.
std::int64_t exact_steps(const units::Position& position, units::StepsPerMeter steps_per_meter);

class PrintRun {
 public:
  PrintRun(const motion::Limits& limits, const RunOptions& options);

  motion::Planner& planner() { return planner_; }

  // Executes the moves from where the axes are until rest.
  RunResult run(const std::vector<motion::LineMove>& moves);

 private:
  struct ExpectedLine {
    units::PerAxis<units::Position> from, to;
  };

  void refill();
  void let_pass(std::uint64_t clocks);
  void feed(const std::vector<motion::LineMove>& moves);
  void check_tick(std::uint32_t ticks, const motion::Segment& segment);
  double distance_steps(const ExpectedLine& line) const;
  void check_segment(const motion::Segment& segment, std::uint64_t rate_before);
  void check_jump(std::size_t axis, const motion::Segment& segment, double rate,
                  double rate_before);
  double axis_speed(const motion::Segment& segment, std::size_t axis, double rate) const;
  double step_mm(std::size_t axis) const;
  units::Microseconds now() const;

  motion::Limits limits_;
  RunOptions options_;
  motion::Planner planner_;
  StepModel model_;
  std::deque<ExpectedLine> expected_;
  units::PerAxis<units::Position> line_end_{};  // of the last line that the planner took
  std::optional<motion::Segment> before_;
  std::size_t fed_{};
  RunResult result_{};
};

}  // namespace motion_test
