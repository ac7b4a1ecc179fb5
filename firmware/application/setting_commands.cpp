// SPDX-License-Identifier: Apache-2.0
// Changes of the limits, each line as a whole, and their reports.
#include "application/setting_commands.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "application/filament_commands.hpp"
#include "application/levelling_reports.hpp"
#include "application/setting_reports.hpp"
#include "application/shaping_commands.hpp"
#include "units/call_table.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

constexpr std::int64_t nanometers_per_micrometer = 1000;

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
      .recovery{{{'S', motion::set_recovery_extra}, {'F', motion::set_recovery_speed}}},
      .automatic{{{'S', motion::set_automatic_retraction}}}};
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
  if (!automatic_retraction_in_image && command.command.code == 209) {
    return command.report_not_fitted();
  }
  motion::Limits changed = motion_.limits();
  std::span<const Setting> settings = settings_.retraction;
  if (command.command.code == 208) settings = settings_.recovery;
  if (automatic_retraction_in_image && command.command.code == 209) settings = settings_.automatic;
  return set_limits(command, changed, change_for_all(changed, command, settings));
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
  if (!automatic_retraction_in_image && command.command.code == 209) {
    return command.report_not_fitted();
  }
  return command.say(setting_report(command.command.code, motion_.limits(), coordinates_.inches()));
}

// The first line stands for inches only.
std::optional<host_link::TextLine> SettingCommands::listed(std::size_t index) const {
  const bool inches = coordinates_.inches();
  if (index == 0) return host_link::TextLine().text("echo: G20 ; Units in inches");
  --index;
  // Whether it is one of the next `lines`; otherwise the index is counted from behind them.
  const auto is_of = [&index](std::size_t lines) {
    if (index < lines) return true;
    index -= lines;
    return false;
  };
  if (is_of(reported_settings.size() - (automatic_retraction_in_image ? 0 : 1))) {
    return setting_report(reported_settings[index], motion_.limits(), inches);
  }
  if (motion_.shapes() && is_of(shaping_reports)) return shaping_report(index, motion_.shaping());
  if (motion_.levels() && is_of(levelling_reports)) {
    return levelling_report(index, motion_.levelling(), inches);
  }
  if constexpr (units::most_tools > 1) {
    const Tools& tools = coordinates_.tools();
    if (tools.count() > 1 && is_of(1)) return tool_change_report(tools.change(), inches);
    if (tools.count() > 1 && is_of(1)) return tool_offset_report(tools.offset(1), inches);
  }
  if (motion_.takes_up_backlash() && is_of(1)) {
    return backlash_report(motion_.backlash().settings(), inches);
  }
  if constexpr (motion::kinematics::Chosen::may_be_delta) {
    if (motion_.kinematics().delta() != nullptr && is_of(2)) return geometry_report(index == 0);
  }
  if (handles_filament()) return filament_->report(index, inches);
  return std::nullopt;
}

// In millimetres as they are, in inches with a first line that says so.
Progress SettingCommands::list(ActiveCommand& command) {
  std::size_t& said = command.lines_said;
  said = std::max<std::size_t>(said, coordinates_.inches() ? 0 : 1);
  // One in each pass.
  const auto line = listed(said);
  if (!line) return Progress::done;
  if (command.say(*line) == Progress::done) ++said;
  return Progress::again;
}

Progress SettingCommands::restore(ActiveCommand& command, bool lists) {
  if (command.phase == ActiveCommand::Phase::begin) {
    if (command.say("echo:Hardcoded Default Settings Loaded") == Progress::again) {
      return Progress::again;
    }
    motion_.set_steps_per_meter(machine_.limits);
    if (motion_.takes_up_backlash()) motion_.set_backlash(*machine_.backlash);
    if constexpr (motion::kinematics::Chosen::may_be_delta) restore_geometry();
    // As at the start, so it is accepted or was refused then.
    if (motion_.shapes()) static_cast<void>(motion_.restore_shaping());
    coordinates_.set_planned(motion_.position());
    // Behind it, so that the host's position follows what levelling has added to Z.
    if (motion_.levels()) motion_.restore_levelling();
    coordinates_.restore_tools(machine_);
    if (handles_filament()) filament_->restore();
    command.phase = ActiveCommand::Phase::working;
    return lists ? Progress::again : Progress::done;
  }
  return list(command);
}

}  // namespace application
