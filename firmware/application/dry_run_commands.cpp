// SPDX-License-Identifier: Apache-2.0
// Refusals of jobs that are only to be tried out.
#include "application/dry_run_commands.hpp"

namespace application {

using namespace std::string_view_literals;

// P has a file of the card simulated, which ends by itself; without S and P it is a question for
// the time that the last simulation took.
Progress DryRunCommands::simulate(ActiveCommand& command) {
  const auto mode = command.integer('S');
  if (mode) simulation_ = *mode != 0;
  if (simulation_) return refuse_line(command);
  const bool ends = mode && !command.command.has('P');
  return ends ? Progress::done : command.refuse("No simulation");
}

// The other bits select messages that this firmware does not have, so they are ignored.
Progress DryRunCommands::set_debug_bits(ActiveCommand& command) {
  constexpr std::int64_t dry_run_bit = 8;
  if (const auto bits = command.integer('S')) dry_run_ = (*bits & dry_run_bit) != 0;
  return dry_run_ ? refuse_line(command) : Progress::done;
}

// In Marlin's words. The bits of messages are not kept.
Progress DryRunCommands::report_debug_bits(ActiveCommand& command) {
  return command.say(dry_run_ ? "echo:DEBUG:DRYRUN, nothing is executed until M111 S0"sv
                              : "echo:DEBUG:off"sv);
}

Progress DryRunCommands::refuse_line(ActiveCommand& command) const {
  return command.refuse(dry_run_ ? "No dry run, nothing is executed until M111 S0"sv
                                 : "No simulation, nothing is executed until M37 S0"sv);
}

}  // namespace application
