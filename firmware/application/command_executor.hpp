// SPDX-License-Identifier: Apache-2.0
// Carries out one G-code line after another, each in as many calls as it needs, and answers it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "application/coordinates.hpp"
#include "application/heat_task.hpp"
#include "application/machine_description.hpp"
#include "application/motion_task.hpp"
#include "application/statistics.hpp"
#include "application/tick_clock.hpp"
#include "drivers/fan.hpp"
#include "gcode/parser.hpp"
#include "host_link/host_link.hpp"
#include "host_link/text_line.hpp"

namespace application {

// Why the executor wants everything to end.
struct Fatal {
  enum class Reason : std::uint8_t { asked_for, homing };  // M112, or G28 that failed
  Reason reason{};
  motion::Fault fault{};  // the last two of homing
  units::Axis axis{};
};

class CommandExecutor {
 public:
  CommandExecutor(const MachineDescription& machine, MotionTask& motion, HeatTask& heat,
                  drivers::Fan& fan, host_link::HostLink& link, Statistics& counters);

  // Goes on with the line in hand, or takes the next one. True if more can be done at once.
  bool update(Now now);
  // Between two passes, and no more than that: questions ahead of the line in hand, or whose turn
  // it is.
  void answer_questions(Now now) {
    if (link_.temperatures_wanted()) update(now);
    answer_queries();
  }

  // M108, M410, M602, M876 and the host's actions, the moment they are received.
  void cancel_wait() {
    if (held_) return hold(false);
    wait_cancelled_ = true;
  }
  void quick_stop();
  // M220 of a person in the midst of a job.
  void set_speed_at_once(std::int32_t percent);
  void prompt_answered() {
    if (stage_ == Stage::asking) wait_cancelled_ = true;
  }
  // Holds back the lines that wait, and motion where it is.
  void hold(bool held);
  void cancel_lines();

  // Whether a line is in hand that is not yet answered, and what it waits for.
  host_link::Activity activity() const;
  // Nothing is lost if it is not called for some milliseconds.
  bool can_wait() const {
    return stage_ == Stage::idle || stage_ == Stage::heating || stage_ == Stage::asking || held_ ||
           waits_for_room_;
  }
  // The move in hand had no room at the last update, and has it now.
  bool has_got_room() const;
  // Something that must end everything.
  const std::optional<Fatal>& fatal() const { return fatal_; }

  // M155: how often temperatures are reported unasked; 0 is never.
  units::Milliseconds report_interval() const { return report_interval_; }
  // M154: the same for positions.
  units::Milliseconds position_interval() const { return position_interval_; }
  // M114's line.
  host_link::TextLine position_line();
  // M86 S: after how long without a word from the host the heaters are switched off; 0 is never.
  units::Milliseconds host_silence() const { return host_silence_; }
  // M84 S: after how long at rest the motors are switched off; 0 is never.
  units::Milliseconds motor_timeout() const { return motor_timeout_; }

 private:
  enum class Stage : std::uint8_t {
    idle,  // no line in hand
    begin,  // the command is to be begun, as soon as what it needs is there
    listing,  // a reply of several lines is being sent
    dwelling,  // G4
    homing,  // G28
    heating,  // M109, M190
    asking,  // M0, M1, M600, M601: the user
    answering,  // done; the ok is due
  };
  // What a handler says: call me again, or I am done.
  enum class Progress : bool { again, done };

  bool take_line();
  void parse(std::string_view text);
  Progress proceed(Now now);
  Progress execute(Now now);
  Progress execute_g(Now now);
  Progress execute_m(Now now);
  Progress execute_setting();

  // motion_commands.cpp
  Progress move();
  Progress dwell(Now now);
  Progress home(Now now);
  Progress set_position();
  Progress wait_for_rest();
  Progress switch_motors(bool enabled);
  Progress wait_for_user(Now now);
  units::Milliseconds asked_time() const;

  // factor_commands.cpp
  Progress set_speed_factor();
  Progress set_flow_factor();
  std::int32_t factor() const;
  Progress report_factor(const char* name, std::int32_t percent);

  // heat_commands.cpp
  bool is_too_hot(Heater heater, units::Millicelsius target) const;
  Progress refuse_heat(Heater heater);
  Progress set_temperature(Heater heater);
  Progress set_and_wait(Heater heater, Now now);
  Progress set_fan();

  // setting_commands.cpp
  Progress set_steps_per_millimeter();
  Progress set_max_accelerations();
  Progress set_max_speeds();
  Progress set_accelerations();
  Progress set_advanced();
  Progress set_interval(units::Milliseconds& interval, std::int64_t longest_s);
  Progress tell_interval(units::Milliseconds interval);
  Progress set_busy_interval();
  Progress set_host_silence();
  Progress update_firmware();

  // setting_reports.cpp
  Progress report_setting();
  Progress list_settings();

  // report_commands.cpp
  Progress report_position();
  Progress report_temperature(Now now);
  Progress list_firmware(std::size_t& index);
  void answer_queries();
  Progress list_end_stops();
  Progress say_text();
  Progress select_tool();
  Progress refuse_unknown();
  Progress refuse_tool();

  // Says one line as the whole of a command, or again later.
  Progress say(std::string_view line);
  Progress say(const host_link::TextLine& line) { return say(line.view()); }
  // Says why nothing is done, as the whole of a command.
  Progress refuse(const host_link::TextLine& line);
  Progress refuse(std::string_view reason);
  Progress refuse_without_card();
  bool is_withheld() const;

  // A limit that is not of one axis, and the letter of its value.
  struct Setting {
    char letter;
    motion::Accepted (*set)(motion::Limits&, units::Nanometers);
  };
  Progress set_for_all(std::span<const Setting> settings);
  template <class Quantity>
  Progress set_per_axis(motion::Accepted (*set)(motion::Limits&, units::Axis, Quantity));

  bool has_any(std::string_view letters) const;
  std::optional<char> letter_without_number(std::string_view letters) const;
  units::AxisSet named_axes() const;
  bool wants_other_tool() const;
  void follow_position_jump();

  const MachineDescription& machine_;
  MotionTask& motion_;
  HeatTask& heat_;
  drivers::Fan& fan_;
  host_link::HostLink& link_;
  Statistics& counters_;

  Coordinates coordinates_;
  Stage stage_{Stage::idle};
  std::string_view text_;  // of the line in hand
  gcode::Command command_;
  std::optional<gcode::ParseError> parse_error_;
  host_link::TextLine ok_report_;
  std::optional<Fatal> fatal_;
  std::size_t list_index_{};
  std::size_t query_index_{};  // the same of a query that is answered ahead
  std::uint32_t position_jumps_{};
  Positions planned_{};  // machine coordinates of the end of the last move
  std::int32_t kept_speed_{100};  // M220 B
  units::AxisSet homing_axes_;
  units::Milliseconds deadline_{};  // of a dwell, or of the next report while heating
  bool wait_cancelled_{};
  bool waits_for_room_{};  // the planner holds as many lines as it can
  bool held_{};
  std::size_t cancelled_lines_{};  // to be answered, not executed
  bool refused_{};
  bool storing_{};  // between M28 and M29: there is no card, and nothing is executed
  bool file_refused_{};  // of M23, which M24 would print
  bool notified_{};  // of the extrusion that this move leaves out
  units::Milliseconds busy_interval_{2000};
  units::Milliseconds report_interval_{};
  units::Milliseconds position_interval_{};
  units::Milliseconds host_silence_{};
  units::Milliseconds motor_timeout_{};
};

}  // namespace application
