// SPDX-License-Identifier: Apache-2.0
// `print --replay`: the netlist of the whole chip replays parts of the print, or all of it.
#pragma once

#include <cstdint>

#include "sim/replay/interval_check.hpp"
#include "sim/replay/interval_recorder.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/command/print_job.hpp"

namespace command {

enum class ReplayOutcome : std::uint8_t {
  same,
  different,
  none_compared,  // the print has none of the chosen intervals
  cut_short,  // by Ctrl-C or `kill`: some were not compared, and the others were the same
};

class ReplayCheck {
 public:
  // Records the chip from now on: before its first clock. Throws std::runtime_error where it cannot
  // be recorded.
  ReplayCheck(const ReplayChoices& choices, const PrinterChoices& printer,
              sim::VerilatedChip& chip);

  // At the end of the print, an interrupted one too. Waits for the replays, which end early when an
  // interrupt is requested, and prints the outcome.
  ReplayOutcome finish();

 private:
  void say_what_was_not_compared(const replay::CheckResult& result) const;

  ReplayChoices choices_;
  std::uint64_t seed_;
  sim::VerilatedChip& chip_;
  replay::IntervalCheck check_;
  replay::IntervalRecorder recorder_;
};

}  // namespace command
