// SPDX-License-Identifier: Apache-2.0
// The firmware's planner, from positions to segments, on the moves of a sliced file.
#pragma once

#include <array>
#include <string_view>

#include "benchmark/processor.hpp"
#include "motion/planner.hpp"

namespace benchmark {

class PlannerWork {
 public:
  PlannerWork();
  // Reads the moves from lines of G0 and G1 in absolute millimetres; the first only says
  // where to begin.
  void prepare(std::string_view text);
  // An iteration is all moves, there and then back; units are moves.
  ProcessorResult run(std::uint32_t iterations);

 private:
  static constexpr std::size_t most_moves = 240;

  void append(const motion::LineMove& move, ProcessorResult& result);
  bool take_segments(ProcessorResult& result);

  motion::Planner planner_;
  std::array<motion::LineMove, most_moves> moves_{};
  std::size_t count_{};
  units::Microseconds now_{};
};

}  // namespace benchmark
