// SPDX-License-Identifier: Apache-2.0
// The task set: the tasks of each pass of the loop, in order of priority, and the halt after
// a fault.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "application/command_executor.hpp"
#include "application/hang_up.hpp"
#include "application/hardware.hpp"
#include "application/heat_task.hpp"
#include "application/machine_description.hpp"
#include "application/motion_task.hpp"
#include "application/statistics.hpp"
#include "application/task_timing.hpp"
#include "application/task_watch.hpp"
#include "application/tick_clock.hpp"
#include "host_link/host_link.hpp"
#include "units/task_span.hpp"

namespace application {

class Application {
 public:
  // Everything handed over must outlive the application.
  Application(const MachineDescription& machine, const ThermalTables& tables, Hardware& hardware,
              Statistics& counters, const OptionalParts& parts = {});

  // Sets up the peripherals and greets the host. False where the clock is too slow for a serial
  // line of so many baud.
  [[nodiscard]] bool start(std::uint32_t baud);

  // One pass over all tasks, with at most one command; never waits. True if there is more to do at
  // once; otherwise the next pass is wanted at the next interrupt (timer, serial line, stop
  // of motion).
  bool update();

  bool halted() const { return halted_; }
  // M999 after a fault: the program is to restart.
  bool restart_wanted() const { return restart_wanted_; }

  // For tests.
  const CommandExecutor& executor() const { return executor_; }
  const MotionTask& motion() const { return motion_; }
  const HeatTask& heat() const { return heat_; }

 private:
  bool work(const Now& now);
  bool refill();
  [[gnu::noinline]] bool may_begin(units::Task task);
  std::int32_t need_of(units::Task task) const;
  std::int32_t left_in_hand() const;
  void set_alarms();
  static constexpr std::size_t most_bytes = task_timing::bytes_of_a_look;
  bool exchange_bytes(const Now& now);
  [[gnu::noinline]] bool receive(const Now& now);
  void transmit();
  void act_on_emergencies();
  void note_cooling(const Now& now);
  void look_for_faults();
  template <units::Task task, class Work>
  auto run(const Work& work);
  bool report(const Now& now);
  // Not inlined, or their lines would lie on the stack below each task.
  [[gnu::noinline]] void say_temperatures();
  [[gnu::noinline]] void say_position();
  void switch_off_idle_motors(const Now& now);
  bool switch_off_forgotten_heaters(const Now& now);
  void count(const Now& now);
  void halt(std::string_view fault);
  void serve_halted(const Now& now);

  const MachineDescription& machine_;
  Hardware& hardware_;
  Statistics& counters_;
  TaskWatch task_watch_;
  TickClock clock_;
  MotionTask motion_;
  HeatTask heat_;
  host_link::HostLink link_;
  CommandExecutor executor_;
  HangUp hang_up_;

  units::Milliseconds next_report_{};
  units::Milliseconds next_position_{};
  units::Milliseconds last_work_{};
  units::Milliseconds next_count_{};
  units::Milliseconds next_complaint_{};
  units::Milliseconds at_rest_since_{};
  units::Milliseconds next_cooling_{};
  std::uint32_t extruder_steps_{};  // when it was looked at last
  [[no_unique_address]] units::IfTwoTools<std::uint8_t> extruder_{};  // likewise
  host_link::TextLine fault_;
  std::uint32_t longest_pass_clocks_{};  // what a refill is to have in hand
  // When all is over that motion has in hand behind the last refill: the lower half of the time.
  std::uint32_t in_hand_until_{};
  bool in_haste_{};  // whether it goes on into lines that wait
  units::Task next_{};  // of the round, that a pass goes on with
  bool halted_{};
  bool restart_wanted_{};
};

}  // namespace application
