// SPDX-License-Identifier: Apache-2.0
// The commands for host and user: M0 M1 M25 M73 M85 M86 M112 M113 M118 M486 M500 M504 M524 M600
// M601 M808 M997, those that only get an ok, and those for parts that this printer does not have.
#pragma once

#include "application/active_command.hpp"
#include "host_link/host_link.hpp"

namespace application {

// What the user is asked: M0 and M1, M600, M601.
enum class Question : std::uint8_t { go_on, change_filament, end_pause };

class HostCommands {
 public:
  HostCommands(host_link::HostLink& link, units::Milliseconds host_silence)
      : link_(link), host_silence_(host_silence) {}

  Progress ask_user(ActiveCommand& command, Question question);
  Progress request_pause(ActiveCommand& command) { return command.say("//action:pause"); }
  Progress request_cancel(ActiveCommand& command) { return command.say("//action:cancel"); }
  Progress say_text(ActiveCommand& command);
  Progress stop_everything(ActiveCommand& command);
  Progress set_busy_interval(ActiveCommand& command);
  Progress report_busy_interval(ActiveCommand& command);
  Progress set_inactivity(ActiveCommand& command);
  Progress report_inactivity(ActiveCommand& command);
  Progress set_host_silence(ActiveCommand& command);
  Progress report_host_silence(ActiveCommand& command);
  // Names of a print's parts are passed over, with a notice at the first; a request to leave one
  // out is refused.
  Progress note_object(ActiveCommand& command);
  Progress set_progress(ActiveCommand& command);
  Progress report_progress(ActiveCommand& command);
  Progress report_not_fitted(ActiveCommand& command) { return command.report_not_fitted(); }
  Progress refuse_end_stops(ActiveCommand& command);
  Progress refuse_to_store(ActiveCommand& command) { return command.refuse("EEPROM disabled"); }
  Progress refuse_repeats(ActiveCommand& command);
  Progress update_firmware(ActiveCommand& command);
  // Done on reception, or there is no display for it.
  Progress accept(ActiveCommand&) { return Progress::done; }

  // M86 S: after how long without a word from the host the heaters are switched off; 0 is never.
  units::Milliseconds host_silence() const { return host_silence_; }
  // M85 S: after how long without work or a word the printer halts; 0 is never.
  units::Milliseconds inactivity() const { return inactivity_; }

 private:
  host_link::HostLink& link_;
  units::Milliseconds answer_due_{};  // of the user; 0: whenever
  units::Milliseconds busy_interval_{host_link::HostLink::longest_silence};
  units::Milliseconds host_silence_;
  units::Milliseconds inactivity_{};
  // M73, of the print; minutes.
  std::uint16_t time_left_{};
  std::uint8_t percent_done_{};
  bool objects_noted_{};
};

}  // namespace application
