// SPDX-License-Identifier: Apache-2.0
// The timer of the print: M31 M75 M76 M77 M78.
#pragma once

#include "application/active_command.hpp"

namespace application {

class TimerCommands {
 public:
  Progress start(ActiveCommand& command);
  Progress pause(ActiveCommand& command);
  Progress stop(ActiveCommand& command);
  Progress report_time(ActiveCommand& command);
  // Since the reset: nothing is stored. S78 resets them.
  Progress report_statistics(ActiveCommand& command);

  // What M109 and M190 do, and M104 and M140 where nothing is heated any more.
  void begin(units::Milliseconds now);
  void end(units::Milliseconds now);
  bool running() const { return state_ == State::running; }

 private:
  enum class State : std::uint8_t { stopped, running, paused };

  units::Milliseconds duration(units::Milliseconds now) const;

  State state_{State::stopped};
  units::Milliseconds began_{};  // running: what went before is in counted_
  units::Milliseconds counted_{};
  std::uint32_t prints_{};
  std::uint32_t finished_{};
  units::Milliseconds total_{};
  units::Milliseconds longest_{};
};

}  // namespace application
