// SPDX-License-Identifier: Apache-2.0
// The commands for heaters and fan: M104 M106 M107 M109 M140 M190.
#include <algorithm>

#include "application/command_executor.hpp"
#include "host_link/replies.hpp"

namespace application {
namespace {

constexpr units::Milliseconds report_period{1000};
constexpr std::int64_t millionths_per_millicelsius = 1000;

// Beyond any heater, which is refused.
units::Millicelsius temperature_of(std::int64_t millionths) {
  constexpr std::int64_t highest = 2'000'000;
  return units::Millicelsius(static_cast<std::int32_t>(
      std::clamp<std::int64_t>(millionths / millionths_per_millicelsius, 0, highest)));
}

std::optional<std::int32_t> whole_seconds(std::optional<units::Milliseconds> time) {
  if (!time) return std::nullopt;
  return static_cast<std::int32_t>((time->count() + 999) / 1000);
}

}  // namespace

// A target that the heater may not be asked for changes nothing: a lower one, as Marlin takes,
// would spoil the print without a word.
bool CommandExecutor::is_too_hot(Heater heater, units::Millicelsius target) const {
  return target > heat_.loop(heater).highest_target();
}

CommandExecutor::Progress CommandExecutor::refuse_heat(Heater heater) {
  host_link::TextLine reason;
  reason.text("Above the highest target of ");
  return refuse(reason.decimal(heat_.loop(heater).highest_target().count(), 3, 2).view());
}

CommandExecutor::Progress CommandExecutor::set_temperature(Heater heater) {
  if (heater == Heater::hotend && wants_other_tool()) return refuse_tool();
  const auto value = command_.value('S');
  if (!value) return Progress::done;
  const units::Millicelsius target = temperature_of(*value);
  if (is_too_hot(heater, target)) return refuse_heat(heater);
  heat_.set_target(heater, target);
  return Progress::done;
}

// S waits only for heating, R for cooling too.
CommandExecutor::Progress CommandExecutor::set_and_wait(Heater heater, Now now) {
  const thermal::HeaterLoop& loop = heat_.loop(heater);
  if (stage_ == Stage::begin) {
    if (heater == Heater::hotend && wants_other_tool()) return refuse_tool();
    const bool waits_for_cooling = command_.value('R').has_value();
    const auto target = waits_for_cooling ? command_.value('R') : command_.value('S');
    if (!target) return Progress::done;
    if (is_too_hot(heater, temperature_of(*target))) return refuse_heat(heater);
    heat_.set_target(heater, temperature_of(*target));
    const auto temperature = loop.temperature();
    const bool must_cool = temperature && loop.target() < *temperature;
    if (must_cool && !waits_for_cooling) return Progress::done;
    deadline_ = now.milliseconds + report_period;
    stage_ = Stage::heating;
  }
  if (loop.at_target() || wait_cancelled_) return Progress::done;
  if (now.milliseconds >= deadline_) {
    const auto line =
        host_link::heating_report(heat_.state(Heater::hotend), heat_.state(Heater::bed),
                                  whole_seconds(loop.time_to_arrival(now.milliseconds)));
    if (link_.say(line.view())) deadline_ += report_period;
  }
  return Progress::again;
}

CommandExecutor::Progress CommandExecutor::set_fan() {
  if (command_.integer('P').value_or(0) != 0) return Progress::done;  // there is one fan, number 0
  const bool on = command_.code == 106;
  const std::int64_t duty = on ? command_.integer('S').value_or(drivers::Fan::full_duty) : 0;
  fan_.set_duty(
      static_cast<std::uint8_t>(std::clamp<std::int64_t>(duty, 0, drivers::Fan::full_duty)));
  return Progress::done;
}

}  // namespace application
