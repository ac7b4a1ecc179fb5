// SPDX-License-Identifier: Apache-2.0
// Writes a random run as a file of stimuli, and the edges that the Verilated step generator makes
// of it. Usage: step_generator_edges SEED SEGMENTS STIMULI_FILE EDGES_FILE. Prints the clocks that
// the run takes.
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "tests/drivers/step_generator_replay.hpp"
#include "tests/motion_reference/random_stimuli.hpp"

int main(int argument_count, char** arguments) {
  if (argument_count != 5) {
    std::fprintf(stderr, "usage: step_generator_edges SEED SEGMENTS STIMULI_FILE EDGES_FILE\n");
    return 2;
  }
  const auto seed = static_cast<std::uint32_t>(std::strtoul(arguments[1], nullptr, 10));
  const auto run = motion_reference::random_run(seed, std::strtoul(arguments[2], nullptr, 10));
  std::ofstream stimuli(arguments[3]);
  motion_reference::save(stimuli, run.stimuli);
  tests::StepGeneratorReplay replay(run.stimuli);
  std::ofstream edges(arguments[4]);
  motion_reference::save(edges, replay.run(run.clocks));
  std::printf("%llu\n", static_cast<unsigned long long>(run.clocks));
  return stimuli.good() && edges.good() ? 0 : 1;
}
