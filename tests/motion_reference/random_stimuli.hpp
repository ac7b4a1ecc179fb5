// SPDX-License-Identifier: Apache-2.0
// Generates random actions of software and end stops on a step generator, the same for the
// same seed.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/motion_reference/step_generator_reference.hpp"

namespace motion_reference {

struct RandomRun {
  std::vector<Stimulus> stimuli;
  std::uint64_t clocks{};
  // What the reference answered.
  std::vector<Edge> edges;
  StepGeneratorReference reference;
};

// Guards, rate floor, then `segments` random segments: lines in one or more parts, all rates up to
// 1/2, ramps, reversals, single ticks, empty queues, and among them refused words, stops, flushes,
// snapshots and positions. A third of the seeds have the shortest guards, a sixteenth long ones.
RandomRun random_run(std::uint32_t seed, std::size_t segments);

}  // namespace motion_reference
