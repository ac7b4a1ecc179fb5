// SPDX-License-Identifier: Apache-2.0
// Runs a program on the chip and compares the clock of each event with the table of times.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace processor {

struct TimedRunSettings {
  std::uint64_t clocks = 100'000;
  unsigned bus_wait = 1;
  // Interrupts are requested in any clocks; 0: none.
  std::uint32_t seed = 0;
  // With none requested, the next comes at most so many clocks later.
  unsigned longest_pause = 60;
};

struct TimedRun {
  // Empty: each event came in its clock; otherwise the first that did not.
  std::string difference;
  std::uint64_t instructions = 0;
  std::uint64_t interrupts = 0;
  // For each row of the table, how often such an instruction was interrupted, and how often an
  // interrupt was taken right after one.
  std::map<std::string, std::uint64_t> interrupted;
  std::map<std::string, std::uint64_t> behind;
};

TimedRun run_timed(const std::vector<std::uint8_t>& image, const TimedRunSettings& settings);

}  // namespace processor
