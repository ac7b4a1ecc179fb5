// SPDX-License-Identifier: Apache-2.0
// The commands that move or wait: G0 G1 G4 G28 G92 M0 M1 M17 M18 M84 M400 M600 M601.
#include <algorithm>
#include <iterator>

#include "application/command_executor.hpp"
#include "host_link/replies.hpp"
#include "motion/steps.hpp"

namespace application {
namespace {

using units::Axis;
using units::index_of;

// Marlin's EXTRUDE_MAXLENGTH: more filament in one line, forward or back, is taken for a mistake.
constexpr units::Nanometers longest_extrusion{200'000'000};
constexpr units::Milliseconds longest_dwell{24 * 3600 * 1000};
constexpr std::int64_t millionths_per_millisecond = 1'000'000 / 1000;  // of a second's parameter

constexpr units::PerAxis<Axis> all_axes{Axis::x, Axis::y, Axis::z, Axis::e};

bool representable(const Positions& positions) {
  return std::ranges::all_of(positions, [](const units::Position& position) {
    return position <= motion::max_position && -position <= motion::max_position;
  });
}

// "Move beyond the end of X (0.00 to 200.00)"
host_link::TextLine beyond(Axis axis, units::Nanometers travel) {
  host_link::TextLine line;
  line.text("Move beyond the end of ").character(units::axis_letters[index_of(axis)]);
  return line.text(" (0.00 to ").decimal(travel.count(), 6, 2).character(')');
}

// "Number missing after X"
host_link::TextLine missing_number(char letter) {
  host_link::TextLine line;
  return line.text("Number missing after ").character(letter);
}

}  // namespace

CommandExecutor::Progress CommandExecutor::move() {
  waits_for_room_ = !motion_.has_room();
  if (waits_for_room_ || motion_.stopping()) return Progress::again;
  if (const auto letter = letter_without_number("XYZEF"))
    return refuse(missing_number(*letter).view());
  coordinates_.take_feedrate(command_);
  const Positions wanted = coordinates_.target_of(command_);
  if (!representable(wanted)) return refuse("Number out of range");

  Positions driven = wanted;
  units::Position& extruder = driven[index_of(Axis::e)];
  const units::Position before = coordinates_.logical()[index_of(Axis::e)];
  if (extruder != before) {
    const bool too_long =
        extruder - before > longest_extrusion || before - extruder > longest_extrusion;
    if (heat_.extrusion_is_cold() || too_long) {
      const char* notice =
          too_long ? "echo: too long extrusion prevented" : "echo: cold extrusion prevented";
      if (!notified_ && say(notice) == Progress::again) return Progress::again;
      notified_ = true;
      extruder = before;
    }
  }

  const Positions machine = coordinates_.machine_target(driven, motion_.position());
  if (!representable(machine)) return refuse("Number out of range");
  if (const auto axis = motion::check_bounds(motion_.limits(), motion_.homed(), machine)) {
    return refuse(beyond(*axis, motion_.limits().of(*axis).travel).view());
  }
  const auto accepted = motion_.append({.target = machine, .feedrate = coordinates_.feedrate()});
  if (!accepted) return refuse(motion::describe(accepted.error()));
  for (const Axis axis : all_axes) coordinates_.set_logical(axis, wanted[index_of(axis)]);
  planned_ = motion_.position();
  return Progress::done;
}

// P in milliseconds or S in seconds.
units::Milliseconds CommandExecutor::asked_time() const {
  units::Milliseconds time{};
  if (const auto milliseconds = command_.integer('P')) time = units::Milliseconds(*milliseconds);
  if (const auto seconds = command_.value('S')) {
    time = units::Milliseconds(*seconds / millionths_per_millisecond);
  }
  return std::clamp(time, units::Milliseconds{}, longest_dwell);
}

CommandExecutor::Progress CommandExecutor::dwell(Now now) {
  if (stage_ == Stage::begin) {
    if (wait_for_rest() == Progress::again) return Progress::again;
    // One more, since the present millisecond has partly passed.
    deadline_ = now.milliseconds + asked_time() + units::Milliseconds(1);
    stage_ = Stage::dwelling;
  }
  return now.milliseconds >= deadline_ ? Progress::done : Progress::again;
}

// Until M108, M602, M876 or, if M0 or M1 has P or S, its end. Hosts that know prompts show a
// button; M600 and M601 also inform hosts that print a file that it is paused, and that it goes on.
CommandExecutor::Progress CommandExecutor::wait_for_user(Now now) {
  constexpr std::uint16_t filament_change = 600;
  const bool pauses = command_.code >= filament_change;
  if (stage_ == Stage::begin) {
    if (wait_for_rest() == Progress::again) return Progress::again;
    static constexpr const char* prompt[]{"paused", "prompt_begin ", "prompt_button Continue",
                                          "prompt_show"};
    if (!pauses && list_index_ == 0) list_index_ = 1;
    for (; list_index_ < std::size(prompt); ++list_index_) {
      host_link::TextLine line;
      line.text("//action:").text(prompt[list_index_]);
      if (list_index_ == 1) {
        line.text(!pauses                            ? "Waiting for the user"
                  : command_.code == filament_change ? "Change the filament"
                                                     : "Paused");
      }
      if (say(line) == Progress::again) return Progress::again;
    }
    const auto time = pauses ? units::Milliseconds{} : asked_time();
    deadline_ = time.count() > 0 ? now.milliseconds + time : units::Milliseconds{};
    list_index_ = 0;
    stage_ = Stage::asking;
  }
  const bool over = deadline_.count() != 0 && now.milliseconds >= deadline_;
  if (!over && !wait_cancelled_) return Progress::again;
  if (list_index_ == 0 && say("//action:prompt_end") == Progress::again) return Progress::again;
  list_index_ = 1;
  return pauses ? say("//action:resumed") : Progress::done;
}

CommandExecutor::Progress CommandExecutor::home(Now) {
  if (stage_ == Stage::begin) {
    if (wait_for_rest() == Progress::again) return Progress::again;
    homing_axes_ = named_axes();
    homing_axes_.remove(Axis::e);
    if (homing_axes_.empty()) homing_axes_ = units::AxisSet::all();
    motion_.start_homing(homing_axes_);
    stage_ = Stage::homing;
    return Progress::again;
  }
  if (const auto fault = motion_.homing_fault()) {
    fatal_ = {Fatal::Reason::homing, *fault, motion_.homing_axis()};
    return Progress::done;
  }
  if (!motion_.at_rest()) return Progress::again;
  // A homed axis loses what G92 has shifted, as in Marlin.
  for (const Axis axis : all_axes) {
    if (homing_axes_.contains(axis) && motion_.homed().contains(axis)) {
      coordinates_.set_logical(axis, motion_.position()[index_of(axis)]);
    }
  }
  return Progress::done;
}

CommandExecutor::Progress CommandExecutor::set_position() {
  if (const auto letter = letter_without_number("XYZE"))
    return refuse(missing_number(*letter).view());
  Positions positions = coordinates_.logical();
  for (const Axis axis : all_axes) {
    const auto value = coordinates_.length(command_, units::axis_letters[index_of(axis)]);
    if (value) positions[index_of(axis)] = *value;
  }
  if (!representable(positions)) return refuse("Number out of range");
  for (const Axis axis : all_axes) coordinates_.set_logical(axis, positions[index_of(axis)]);
  return Progress::done;
}

CommandExecutor::Progress CommandExecutor::wait_for_rest() {
  motion_.flush();
  return motion_.at_rest() ? Progress::done : Progress::again;
}

CommandExecutor::Progress CommandExecutor::switch_motors(bool enabled) {
  units::AxisSet axes = named_axes();
  if (!enabled) {
    // M84 S: only the time after which they are switched off by themselves.
    if (const auto seconds = command_.integer('S')) {
      constexpr std::int64_t longest_s = 24 * 3600;
      motor_timeout_ = units::Milliseconds(std::clamp<std::int64_t>(*seconds, 0, longest_s) * 1000);
      return Progress::done;
    }
    if (wait_for_rest() == Progress::again) return Progress::again;
  }
  if (axes.empty()) axes = units::AxisSet::all();
  motion_.enable_motors(axes, enabled);
  return Progress::done;
}

bool CommandExecutor::has_any(std::string_view letters) const {
  return std::ranges::any_of(letters, [this](char letter) { return command_.has(letter); });
}

// The first of `letters` that the line has, but without a number.
std::optional<char> CommandExecutor::letter_without_number(std::string_view letters) const {
  const auto bare = std::ranges::find_if(letters, [this](char letter) {
    return command_.has(letter) && !command_.value(letter).has_value();
  });
  return bare == letters.end() ? std::nullopt : std::optional(*bare);
}

units::AxisSet CommandExecutor::named_axes() const {
  units::AxisSet axes;
  for (const Axis axis : all_axes) {
    if (command_.has(units::axis_letters[index_of(axis)])) axes.insert(axis);
  }
  return axes;
}

// After a stop or homing the machine is not where the last move ended: what the host believes moves
// with it.
void CommandExecutor::follow_position_jump() {
  if (motion_.position_jumps() == position_jumps_) return;
  position_jumps_ = motion_.position_jumps();
  for (const Axis axis : all_axes) {
    const std::size_t i = index_of(axis);
    coordinates_.set_logical(axis,
                             coordinates_.logical()[i] + (motion_.position()[i] - planned_[i]));
  }
  planned_ = motion_.position();
}

}  // namespace application
