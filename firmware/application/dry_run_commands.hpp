// SPDX-License-Identifier: Apache-2.0
// The commands that start a dry run in other firmwares: M37 (RepRapFirmware's simulation) and M111
// with the bit of Marlin's dry run. There is neither here.
#pragma once

#include "application/active_command.hpp"

namespace application {

class DryRunCommands {
 public:
  Progress simulate(ActiveCommand& command);
  Progress set_debug_bits(ActiveCommand& command);
  Progress report_debug_bits(ActiveCommand& command);

  // Lines that a host sends for a dry run must not be executed.
  bool asked_for() const { return simulation_ || dry_run_; }
  // Says what ends it.
  Progress refuse_line(ActiveCommand& command) const;

 private:
  // Each has its own end.
  bool simulation_{};
  bool dry_run_{};
};

}  // namespace application
