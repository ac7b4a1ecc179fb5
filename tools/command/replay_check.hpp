// SPDX-License-Identifier: Apache-2.0
// `print --replay`: the netlist of the whole chip replays parts of the print, or all of it.
#pragma once

#include <cstdint>

#include "sim/replay/interval_check.hpp"
#include "sim/replay/interval_recorder.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/command/print_job.hpp"

namespace command {

class ReplayCheck {
 public:
  // Records the chip from now on: before its first clock. Throws std::runtime_error where it cannot
  // be recorded.
  ReplayCheck(const ReplayChoices& choices, const PrinterChoices& printer,
              sim::VerilatedChip& chip);

  // At the end of the print. Prints the outcome; returns whether every replayed interval was
  // the same.
  bool finish();

 private:
  std::uint64_t seed_;
  bool at_random_;
  sim::VerilatedChip& chip_;
  replay::IntervalCheck check_;
  replay::IntervalRecorder recorder_;
};

}  // namespace command
