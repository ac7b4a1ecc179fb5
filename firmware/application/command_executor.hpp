// SPDX-License-Identifier: Apache-2.0
// Carries out one G-code line after another, each in as many calls as it needs, and answers it. It
// finds the row of the command, waits for what that says, checks arguments, and calls the handler.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "application/active_command.hpp"
#include "application/command_groups.hpp"
#include "application/gcode_entry.hpp"
#include "application/statistics.hpp"
#include "gcode/parse_error.hpp"

namespace application {

class CommandExecutor {
 public:
  CommandExecutor(const MachineDescription& machine, MotionTask& motion, HeatTask& heat,
                  drivers::Fan& fan, host_link::HostLink& link, Statistics& counters,
                  FilamentCommands* filament = nullptr);

  // Goes on with the line in hand, or takes the next one. True if more can be done at once.
  [[gnu::noinline]] bool update(const Now& now);

  // M108, M410, M602, M876 and the host's actions, the moment they are received.
  void cancel_wait() {
    if (held_) return hold(false);
    active_.wait_cancelled = true;
  }
  void quick_stop();
  // M220 of a person in the middle of a job.
  void set_speed_at_once(std::int32_t percent) { groups_.factors.set_speed_at_once(percent); }
  void prompt_answered() {
    if (asks_user()) active_.wait_cancelled = true;
  }
  // Holds back the lines that wait, and motion where it is.
  void hold(bool held);
  void cancel_lines();

  // Whether a line is in hand that is not yet answered, and what it waits for.
  host_link::Activity activity() const;
  // Nothing is lost if it is not called for some milliseconds.
  bool can_wait() const {
    return stage_ == Stage::idle || waits_for_heat() || asks_user() || held_ || waits_for_room_ ||
           appends();
  }
  // The move in hand had no room at the last update, or its next part needs some, and has it now.
  bool has_got_room() const;
  // A fault that must end everything.
  const std::optional<Fatal>& fatal() const { return active_.fatal; }

  // Settings made by commands.
  const CommandGroups& groups() const { return groups_; }

 private:
  enum class Stage : std::uint8_t {
    idle,  // no line in hand
    executing,
    answering,  // done; the ok is due
  };

  bool take_line();
  Stage parse(std::string_view text);
  void find_row();
  Progress proceed();
  std::optional<Progress> prepare();
  bool may_start();
  Progress refuse_unparsed();
  bool answer_query();
  void follow_position_jump();

  bool begins() const {
    return stage_ == Stage::executing && active_.phase == ActiveCommand::Phase::begin;
  }
  bool waits_for_heat() const {
    return stage_ == Stage::executing && active_.phase == ActiveCommand::Phase::heating;
  }
  bool appends() const {
    return stage_ == Stage::executing && active_.phase == ActiveCommand::Phase::appending;
  }
  bool asks_user() const {
    return stage_ == Stage::executing && active_.phase == ActiveCommand::Phase::asking;
  }

  MotionTask& motion_;
  host_link::HostLink& link_;
  Statistics& counters_;

  CommandGroups groups_;
  Stage stage_{Stage::idle};
  ActiveCommand active_;
  const GcodeEntry* row_{};  // of the command in hand or of the last one
  std::optional<gcode::ParseError> parse_error_;
  Reply query_;  // that is answered ahead
  std::uint32_t position_jumps_{};
  bool waits_for_room_{};  // the planner holds as many lines as it can
  bool held_{};
  bool is_own_{};  // the command in hand is none of the host's
  std::size_t cancelled_lines_{};  // to be answered, not executed
};

}  // namespace application
