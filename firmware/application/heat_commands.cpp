// SPDX-License-Identifier: Apache-2.0
// Targets, waits for heat, and the fan.
#include "application/heat_commands.hpp"

#include <algorithm>

#include "host_link/replies.hpp"

namespace application {
namespace {

constexpr units::Milliseconds report_period{1000};
constexpr std::int64_t millionths_per_millicelsius = 1000;

// Above the range of any heater, and so refused.
units::Millicelsius temperature_of(std::int64_t millionths) {
  constexpr std::int64_t highest = 2'000'000;
  return units::Millicelsius(static_cast<std::int32_t>(
      std::clamp<std::int64_t>(millionths / millionths_per_millicelsius, 0, highest)));
}

std::optional<std::int32_t> whole_seconds(std::optional<units::Milliseconds> time) {
  if (!time) return std::nullopt;
  return static_cast<std::int32_t>((time->count() + 999) / 1000);
}

// A target outside the heater's range changes nothing: a lower one, as Marlin takes,
// would ruin the print without a message.
bool is_too_hot(const thermal::HeaterLoop& loop, units::Millicelsius target) {
  return target > loop.highest_target();
}

Progress refuse_heat(ActiveCommand& command, const thermal::HeaterLoop& loop) {
  host_link::TextLine reason;
  reason.text("Above the highest target of ");
  return command.refuse(reason.decimal(loop.highest_target().count(), 3, 2).view());
}

constexpr std::string_view no_other_units =
    "Temperatures only in degrees Celsius, none is set until M149 C";

// A number in Fahrenheit or Kelvin would be a much hotter one in °C.
Progress refuse_units(ActiveCommand& command) { return command.refuse(no_other_units); }

// There is one fan, number 0.
bool is_for_another_fan(const ActiveCommand& command) {
  return command.integer('P').value_or(0) != 0;
}

}  // namespace

Progress HeatCommands::set_temperature(ActiveCommand& command, Heater heater) {
  const auto value = command.value('S');
  return value ? take_target(command, heater, *value) : Progress::done;
}

// 0 or less is off, whatever the unit: 0 °F and 0 K are below the 0 °C of a heater that is off.
Progress HeatCommands::take_target(ActiveCommand& command, Heater heater, std::int64_t millionths) {
  if (other_units_ && millionths > 0) return refuse_units(command);
  const units::Millicelsius target = temperature_of(millionths);
  if (is_too_hot(heat_.loop(heater), target)) return refuse_heat(command, heat_.loop(heater));
  heat_.set_target(heater, target);
  // The print begins where heat is waited for, and ends where none is wanted, as in Marlin.
  if (!heat_.wanted()) timer_.end(command.now.milliseconds);
  return Progress::done;
}

Progress HeatCommands::set_and_wait(ActiveCommand& command, Heater heater) {
  if (command.phase == ActiveCommand::Phase::begin) {
    if (begin_to_wait(command, heater) == Progress::again) return Progress::again;
    if (command.phase == ActiveCommand::Phase::begin) return Progress::done;
  }
  const thermal::HeaterLoop& loop = heat_.loop(heater);
  if (loop.at_target() || command.wait_cancelled) return Progress::done;
  const units::Milliseconds now = command.now.milliseconds;
  if (now >= next_report_) {
    const auto line =
        host_link::heating_report(heat_.state(Heater::hotend), heat_.state(Heater::bed),
                                  whole_seconds(loop.time_to_arrival(now)));
    if (command.say(line) == Progress::done) next_report_ += report_period;
  }
  return Progress::again;
}

Progress HeatCommands::begin_to_wait(ActiveCommand& command, Heater heater) {
  const thermal::HeaterLoop& loop = heat_.loop(heater);
  const bool waits_for_cooling = command.command.has_number('R');
  const auto value = command.value(waits_for_cooling ? 'R' : 'S');
  if (!value) return Progress::done;
  if (take_target(command, heater, *value) == Progress::again) return Progress::again;
  if (command.refused) return Progress::done;
  const auto temperature = loop.temperature();
  const bool must_cool = temperature && loop.target() < *temperature;
  if (must_cool && !waits_for_cooling) return Progress::done;
  if (heat_.wanted()) timer_.begin(command.now.milliseconds);
  next_report_ = command.now.milliseconds + report_period;
  command.phase = ActiveCommand::Phase::heating;
  return Progress::done;
}

// C counts before the others, as in Marlin.
Progress HeatCommands::set_units(ActiveCommand& command) {
  other_units_ = !command.command.has('C');
  return other_units_ ? refuse_units(command) : Progress::done;
}

// As Marlin does.
Progress HeatCommands::report_units(ActiveCommand& command) {
  host_link::TextLine line;
  if (other_units_) return command.say(line.text("echo:").text(no_other_units));
  return command.say("echo: M149 C ; Units in Celsius");
}

// Without P it is as S says: 0 allows all.
Progress HeatCommands::set_extrusion_limit(ActiveCommand& command) {
  if (const auto least = command.value('S')) {
    if (other_units_ && *least > 0) return refuse_units(command);
    heat_.set_least_extrusion(temperature_of(*least));
  }
  const bool asked_for = command.integer('P').value_or(0) != 0;
  heat_.allow_cold_extrusion(asked_for || heat_.least_extrusion() == units::Millicelsius());
  return Progress::done;
}

// In Marlin's words.
Progress HeatCommands::report_extrusion_limit(ActiveCommand& command) {
  host_link::TextLine line;
  line.text("echo:Cold extrudes are ").text(heat_.cold_extrusion_allowed() ? "en" : "dis");
  line.text("abled (min temp ").integer(heat_.least_extrusion().count() / 1000).text("C)");
  return command.say(line);
}

Progress HeatCommands::set_fan(ActiveCommand& command) {
  if (is_for_another_fan(command)) return Progress::done;
  fan_.set_duty(static_cast<std::uint8_t>(command.integer('S').value_or(drivers::Fan::full_duty)));
  return Progress::done;
}

Progress HeatCommands::stop_fan(ActiveCommand& command) {
  if (!is_for_another_fan(command)) fan_.set_duty(0);
  return Progress::done;
}

// In Marlin's words, by which OctoPrint knows it.
Progress HeatCommands::select_tool(ActiveCommand& command) {
  if (command.command.code == 0) return Progress::done;
  host_link::TextLine line;
  return command.refuse(
      line.text("echo:T").integer(command.command.code).text(" Invalid extruder"));
}

}  // namespace application
