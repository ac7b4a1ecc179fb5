// SPDX-License-Identifier: Apache-2.0
// Changes of the limits, each line as a whole, and their reports.
#include "application/setting_commands.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "application/levelling_reports.hpp"
#include "application/setting_reports.hpp"
#include "application/shaping_commands.hpp"
#include "units/call_table.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

constexpr std::int64_t nanometers_per_micrometer = 1000;
constexpr std::size_t tool_reports = 2;

// Beyond the range of the type it becomes a value that the setting refuses.
template <class Quantity>
Quantity micrometers(units::Nanometers length) {
  using Representation = typename Quantity::Representation;
  constexpr std::int64_t most = std::numeric_limits<Representation>::max();
  const std::int64_t value = length.count() / nanometers_per_micrometer;
  return Quantity(static_cast<Representation>(std::clamp(value, -most, most)));
}

template <auto set, class Quantity>
motion::Accepted set_micrometers(motion::Limits& limits, units::Nanometers value) {
  return set(limits, micrometers<Quantity>(value));
}

// What change_per_axis() may call.
template <class Quantity>
using Setter = motion::Accepted (*)(motion::Limits&, units::Axis, Quantity);
template <class Quantity>
constexpr std::array<Setter<Quantity>, 0> setters{};
template <>
constexpr std::array setters<units::MicrometersPerSecondSquared>{
    Setter<units::MicrometersPerSecondSquared>{motion::set_max_acceleration}};
template <>
constexpr std::array setters<units::MicrometersPerSecond>{
    Setter<units::MicrometersPerSecond>{motion::set_max_speed},
    Setter<units::MicrometersPerSecond>{motion::set_jerk}};

}  // namespace

constinit const SettingCommands::Settings SettingCommands::settings_ = [] {
  using Acceleration = units::MicrometersPerSecondSquared;
  using Speed = units::MicrometersPerSecond;
  constexpr auto print = set_micrometers<motion::set_print_acceleration, Acceleration>;
  constexpr auto travel = set_micrometers<motion::set_travel_acceleration, Acceleration>;
  constexpr auto retract = set_micrometers<motion::set_retract_acceleration, Acceleration>;
  return Settings{
      .accelerations{{{'S', print}, {'S', travel}, {'P', print}, {'T', travel}, {'R', retract}}},
      .advanced{{{'S', set_micrometers<motion::set_min_print_speed, Speed>},
                 {'T', set_micrometers<motion::set_min_travel_speed, Speed>},
                 {'J', motion::set_junction_deviation}}},
      .retraction{{{'S', motion::set_retraction_length},
                   {'F', motion::set_retraction_speed},
                   {'Z', motion::set_retraction_lift}}},
      .recovery{{{'S', motion::set_recovery_extra}, {'F', motion::set_recovery_speed}}}};
}();

// A line with one value out of range changes nothing.
template <class Quantity>
motion::Accepted SettingCommands::change_per_axis(motion::Limits& changed,
                                                  const ActiveCommand& command,
                                                  SetOfAxis<Quantity> set) const {
  units::declare_call_by<setters<Quantity>>();
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto value = coordinates_.rounded_length(command.command, units::axis_letters[i]);
    if (!value) continue;
    const auto accepted = set(changed, static_cast<units::Axis>(i), micrometers<Quantity>(*value));
    if (!accepted) return accepted;
  }
  return {};
}

motion::Accepted SettingCommands::change_for_all(motion::Limits& changed,
                                                 const ActiveCommand& command,
                                                 std::span<const Setting> settings) const {
  units::declare_call_by<settings_>();
  units::LoopBound<std::tuple_size_v<decltype(settings_.accelerations)>> bound;
  for (const Setting& setting : settings) {
    bound.next();
    const auto value = coordinates_.rounded_length(command.command, setting.letter);
    if (!value) continue;
    const motion::Accepted accepted = setting.set(changed, *value);
    if (!accepted) return accepted;
  }
  return {};
}

Progress SettingCommands::set_limits(ActiveCommand& command, const motion::Limits& changed,
                                     motion::Accepted accepted) {
  if (!accepted) return command.refuse(motion::describe(accepted.error()));
  motion_.set_limits(changed);
  return Progress::done;
}

Progress SettingCommands::set_max_accelerations(ActiveCommand& command) {
  motion::Limits changed = motion_.limits();
  return set_limits(command, changed,
                    change_per_axis(changed, command, motion::set_max_acceleration));
}

Progress SettingCommands::set_max_speeds(ActiveCommand& command) {
  motion::Limits changed = motion_.limits();
  return set_limits(command, changed, change_per_axis(changed, command, motion::set_max_speed));
}

// P printing, T travel, R retraction; S is both P and T, as old slicers write it.
Progress SettingCommands::set_accelerations(ActiveCommand& command) {
  motion::Limits changed = motion_.limits();
  return set_limits(command, changed, change_for_all(changed, command, settings_.accelerations));
}

// X Y Z E jerk, J junction deviation, S slowest print move, T slowest travel. B is a number of
// another planner, which has no effect.
Progress SettingCommands::set_advanced(ActiveCommand& command) {
  motion::Limits changed = motion_.limits();
  motion::Accepted accepted = change_per_axis(changed, command, motion::set_jerk);
  if (accepted) accepted = change_for_all(changed, command, settings_.advanced);
  return set_limits(command, changed, accepted);
}

Progress SettingCommands::set_retraction(ActiveCommand& command) {
  motion::Limits changed = motion_.limits();
  return set_limits(command, changed, change_for_all(changed, command, settings_.retraction));
}

Progress SettingCommands::set_recovery(ActiveCommand& command) {
  motion::Limits changed = motion_.limits();
  return set_limits(command, changed, change_for_all(changed, command, settings_.recovery));
}

// The position in millimetres is kept, as in Marlin.
Progress SettingCommands::set_steps_per_millimeter(ActiveCommand& command) {
  motion::Limits changed = motion_.limits();
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto value = command.command.value(units::axis_letters[i]);
    if (!value) continue;
    constexpr std::int64_t millionths_per_thousandth = 1000;
    if (*value % millionths_per_thousandth != 0) return command.refuse("More than three decimals");
    const std::int64_t per_meter = std::clamp<std::int64_t>(
        *value / millionths_per_thousandth, 0, std::numeric_limits<std::int32_t>::max());
    const auto accepted =
        motion::set_steps_per_meter(changed, static_cast<units::Axis>(i),
                                    units::StepsPerMeter(static_cast<std::int32_t>(per_meter)));
    if (!accepted) return command.refuse(motion::describe(accepted.error()));
  }
  motion_.set_steps_per_meter(changed);
  coordinates_.set_planned(motion_.position());
  return Progress::done;
}

// "echo: M203 X200.00 Y200.00 Z12.00 E80.00"
Progress SettingCommands::report(ActiveCommand& command) {
  return command.say(setting_report(command.command.code, motion_.limits(), coordinates_.inches()));
}

// In millimetres as they are, in inches with a first line that says so.
Progress SettingCommands::list(ActiveCommand& command) {
  const std::size_t first = coordinates_.inches() ? 0 : 1;
  std::size_t& said = command.lines_said;
  const std::size_t shaped = reported_settings.size() + (motion_.shapes() ? shaping_reports : 0);
  const std::size_t levelled = shaped + (motion_.levels() ? levelling_reports : 0);
  const std::size_t with_tools = levelled + (coordinates_.tools().count() > 1 ? tool_reports : 0);
  const std::size_t last = with_tools + (motion_.takes_up_backlash() ? 1 : 0);
  units::LoopBound<std::size(reported_settings) + shaping_reports + levelling_reports +
                   tool_reports + 2>
      lines;
  for (said = std::max(said, first); said <= last; ++said) {
    lines.next();
    if (motion_.takes_up_backlash() && said > with_tools) {
      const auto line = backlash_report(motion_.backlash().settings(), coordinates_.inches());
      if (command.say(line) == Progress::again) return Progress::again;
      continue;
    }
    if (units::most_tools > 1 && said > levelled) {
      const Tools& all = coordinates_.tools();
      const auto line = said == with_tools
                            ? tool_offset_report(all.offset(1), coordinates_.inches())
                            : tool_change_report(all.change(), coordinates_.inches());
      if (command.say(line) == Progress::again) return Progress::again;
      continue;
    }
    if (motion_.levels() && said > shaped) {
      const auto line =
          levelling_report(said - shaped - 1, motion_.levelling(), coordinates_.inches());
      if (command.say(line) == Progress::again) return Progress::again;
      continue;
    }
    if (motion_.shapes() && said > reported_settings.size()) {
      const auto line = shaping_report(said - reported_settings.size() - 1, motion_.shaping());
      if (command.say(line) == Progress::again) return Progress::again;
      continue;
    }
    if (said == 0) {
      if (command.say("echo: G20 ; Units in inches") == Progress::again) return Progress::again;
      continue;
    }
    const auto line =
        setting_report(reported_settings[said - 1], motion_.limits(), coordinates_.inches());
    if (command.say(line) == Progress::again) return Progress::again;
  }
  return Progress::done;
}

Progress SettingCommands::restore(ActiveCommand& command, bool lists) {
  if (command.phase == ActiveCommand::Phase::begin) {
    if (command.say("echo:Hardcoded Default Settings Loaded") == Progress::again) {
      return Progress::again;
    }
    motion_.set_steps_per_meter(machine_.limits);
    if (motion_.takes_up_backlash()) motion_.set_backlash(*machine_.backlash);
    // As at the start, so it is accepted or was refused then.
    if (motion_.shapes()) static_cast<void>(motion_.restore_shaping());
    coordinates_.set_planned(motion_.position());
    // Behind it, so that the host's position follows what levelling has added to Z.
    if (motion_.levels()) motion_.restore_levelling();
    coordinates_.restore_tools(machine_);
    command.phase = ActiveCommand::Phase::working;
  }
  return lists ? list(command) : Progress::done;
}

}  // namespace application
