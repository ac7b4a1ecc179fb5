// SPDX-License-Identifier: Apache-2.0
// Takes lines, finds the handler of each command, and sends the ok when it is done.
#include "application/command_executor.hpp"

#include <algorithm>
#include <array>

#include "host_link/replies.hpp"

namespace application {
namespace {

constexpr std::int64_t longest_report_s = 60;

}  // namespace

CommandExecutor::CommandExecutor(const MachineDescription& machine, MotionTask& motion,
                                 HeatTask& heat, drivers::Fan& fan, host_link::HostLink& link,
                                 Statistics& counters)
    : machine_(machine),
      motion_(motion),
      heat_(heat),
      fan_(fan),
      link_(link),
      counters_(counters),
      host_silence_(machine.host_silence) {}

bool CommandExecutor::update(Now now) {
  follow_position_jump();
  answer_queries();
  if (stage_ == Stage::idle && !take_line()) return false;
  if (stage_ != Stage::answering) {
    if (held_ && stage_ == Stage::begin) return false;
    if (proceed(now) == Progress::again || fatal_) return false;
    stage_ = Stage::answering;
  }
  if (!link_.finished(ok_report_.view())) return false;
  ++(refused_ ? counters_.commands_refused : counters_.commands_executed);
  stage_ = Stage::idle;
  return link_.waiting_lines() != 0;
}

bool CommandExecutor::has_got_room() const {
  return waits_for_room_ && stage_ == Stage::begin && !held_ && motion_.has_room();
}

void CommandExecutor::quick_stop() {
  motion_.quick_stop();
  wait_cancelled_ = true;
}

void CommandExecutor::hold(bool held) {
  held_ = held;
  motion_.hold(held);
}

// The host's //action:cancel: what waits in the queue belongs to what is cancelled.
void CommandExecutor::cancel_lines() {
  quick_stop();
  hold(false);
  cancelled_lines_ = link_.waiting_lines();
  if (stage_ == Stage::idle) return;
  --cancelled_lines_;
  if (stage_ == Stage::begin) stage_ = Stage::answering;
}

host_link::Activity CommandExecutor::activity() const {
  using host_link::Activity;
  if (held_ || stage_ == Stage::asking) return Activity::paused_for_user;
  return stage_ == Stage::idle ? Activity::idle : Activity::processing;
}

bool CommandExecutor::take_line() {
  const auto line = link_.next_line();
  if (!line) return false;
  stage_ = Stage::begin;
  text_ = line->text;
  ok_report_.clear();
  parse_error_.reset();
  notified_ = false;
  wait_cancelled_ = false;
  list_index_ = 0;
  const bool cancelled = cancelled_lines_ != 0;
  if (cancelled) --cancelled_lines_;
  refused_ = cancelled && !line->emergency;
  if (line->emergency || cancelled) {
    stage_ = Stage::answering;
  } else {
    parse(line->text);
  }
  if (!parse_error_ || !link_.ask_again()) return true;
  stage_ = Stage::idle;
  return false;
}

void CommandExecutor::parse(std::string_view text) {
  using gcode::ParseFault;
  const auto command = gcode::parse(text);
  if (command) {
    command_ = *command;
    return;
  }
  switch (command.error().fault) {
    case ParseFault::empty_line:
      stage_ = Stage::answering;
      return;
    default:
      parse_error_ = command.error();
  }
}

CommandExecutor::Progress CommandExecutor::proceed(Now now) {
  using gcode::ParseFault;
  if (!parse_error_) return execute(now);
  if (parse_error_->fault == ParseFault::unknown_letter ||
      parse_error_->fault == ParseFault::missing_code) {
    return refuse_unknown();
  }
  return refuse(
      host_link::not_executed(gcode::describe(*parse_error_), parse_error_->position, text_));
}

// There is no card. What a host sends in order to store it is no print; questions and M110 come
// from the host itself.
CommandExecutor::Progress CommandExecutor::refuse_without_card() { return refuse("No SD card"); }

bool CommandExecutor::is_withheld() const {
  constexpr std::array<std::uint16_t, 6> from_the_host_itself{29, 105, 110, 114, 115, 119};
  return storing_ && std::ranges::none_of(from_the_host_itself, [this](std::uint16_t code) {
           return command_.is('M', code);
         });
}

CommandExecutor::Progress CommandExecutor::execute(Now now) {
  if (is_withheld()) return refuse("No SD card until M29");
  switch (command_.letter) {
    case 'G':
      return execute_g(now);
    case 'M':
      return execute_m(now);
    case 'T':
      return select_tool();
    default:
      return refuse_unknown();
  }
}

CommandExecutor::Progress CommandExecutor::execute_g(Now now) {
  if (command_.subcode != 0) return refuse_unknown();
  // An axis that the machine does not have, say: the others must not go without it.
  const bool homes = command_.code == 28;
  if ((homes || command_.code <= 1 || command_.code == 92) &&
      command_.has_besides(homes ? gcode::Command::set_of("XYZEORW")
                                 : gcode::Command::set_of("XYZEF"))) {
    return refuse("Unknown parameter");
  }
  switch (command_.code) {
    case 0:
    case 1:
      return move();
    case 4:
      return dwell(now);
    case 20:
      coordinates_.set_inches(true);
      return Progress::done;
    case 21:
      coordinates_.set_inches(false);
      return Progress::done;
    case 28:
      return home(now);
    case 90:
      coordinates_.set_relative(false);
      return Progress::done;
    case 91:
      coordinates_.set_relative(true);
      return Progress::done;
    case 92:
      return set_position();
    default:
      return refuse_unknown();
  }
}

CommandExecutor::Progress CommandExecutor::execute_m(Now now) {
  if (command_.subcode != 0) return refuse_unknown();
  switch (command_.code) {
    case 0:
    case 1:
    case 600:
    case 601:
      return wait_for_user(now);
    case 17:
      return switch_motors(true);
    case 18:
    case 84:
      return switch_motors(false);
    case 23:
    case 32:
      file_refused_ = true;
      return refuse_without_card();
    case 24:
      if (!file_refused_) return say("//action:resume");
      if (refuse_without_card() == Progress::again) return Progress::again;
      file_refused_ = false;
      return Progress::done;
    case 25:
      return say("//action:pause");
    case 28:
      storing_ = true;
      return refuse("No SD card until M29");
    case 29:
      storing_ = false;
      return refuse_without_card();
    case 82:
      coordinates_.set_extruder_relative(false);
      return Progress::done;
    case 83:
      coordinates_.set_extruder_relative(true);
      return Progress::done;
    case 104:
      return set_temperature(Heater::hotend);
    case 105:
      return report_temperature(now);
    case 106:
    case 107:
      return set_fan();
    case 109:
      return set_and_wait(Heater::hotend, now);
    case 114:
      return report_position();
    case 115:
      return list_firmware(list_index_);
    case 118:
      return say_text();
    case 119:
      return list_end_stops();
    case 140:
      return set_temperature(Heater::bed);
    case 154:
      return set_interval(position_interval_, longest_report_s);
    case 155:
      return set_interval(report_interval_, longest_report_s);
    case 190:
      return set_and_wait(Heater::bed, now);
    case 400:
      return wait_for_rest();
    case 410:
      quick_stop();
      return Progress::done;
    case 112:
      fatal_.emplace(Fatal::Reason::asked_for);
      return Progress::done;
    // Progress and messages have no display here; numbering and what ends a wait were done on
    // reception.
    case 73:
    case 108:
    case 110:
    case 117:
    case 602:
      return Progress::done;
    case 524:
      return say("//action:cancel");
    default:
      return execute_setting();
  }
}

CommandExecutor::Progress CommandExecutor::execute_setting() {
  switch (command_.code) {
    case 808:
      return refuse("No repeats, the lines behind it are executed once");
    case 86:
      return set_host_silence();
    case 92:
      return set_steps_per_millimeter();
    case 113:
      return set_busy_interval();
    case 201:
      return set_max_accelerations();
    case 203:
      return set_max_speeds();
    case 204:
      return set_accelerations();
    case 205:
      return set_advanced();
    case 220:
      return set_speed_factor();
    case 221:
      return set_flow_factor();
    case 503:
      return list_settings();
    case 997:
      return update_firmware();
    default:
      return refuse_unknown();
  }
}

CommandExecutor::Progress CommandExecutor::say(std::string_view line) {
  return link_.say(line) ? Progress::done : Progress::again;
}

CommandExecutor::Progress CommandExecutor::refuse(const host_link::TextLine& line) {
  refused_ = true;
  return say(line);
}

CommandExecutor::Progress CommandExecutor::refuse(std::string_view reason) {
  return refuse(host_link::not_executed(reason, text_));
}

CommandExecutor::Progress CommandExecutor::refuse_unknown() {
  return refuse(host_link::unknown_command(text_));
}

}  // namespace application
