// SPDX-License-Identifier: Apache-2.0
// Targets, waits for heat, and the fan.
#include "application/heat_commands.hpp"

#include <algorithm>

#include "host_link/replies.hpp"

namespace application {

using namespace std::string_view_literals;
namespace {

constexpr units::Milliseconds report_period{1000};
constexpr std::int64_t millionths_per_millicelsius = 1000;

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

// There is one fan, number 0.
bool is_for_another_fan(const ActiveCommand& command) {
  return command.integer('P').value_or(0) != 0;
}

}  // namespace

// To a thousandth of a degree, as the heaters have it. 0 or less is off, whatever the unit: 0 °F
// and 0 K are below the 0 °C of a heater that is off.
units::Millicelsius HeatCommands::temperature_of(std::int64_t millionths) const {
  constexpr std::int32_t highest = 2'000'000;  // above the range of any heater, and so refused
  std::int32_t value = static_cast<std::int32_t>(
      std::clamp<std::int64_t>(millionths / millionths_per_millicelsius, 0, 4 * highest));
  if (unit_ == Unit::fahrenheit) value = (value - 32'000) * 5 / 9;
  if (unit_ == Unit::kelvin) value -= 273'150;
  return units::Millicelsius(std::clamp<std::int32_t>(value, 0, highest));
}

// T of a hotend, of the tool in use without it.
Heater HeatCommands::heater_of(const ActiveCommand& command, Heater heater) const {
  if (units::most_tools == 1 || heater != Heater::hotend) return heater;
  const auto tool = command.command.integer('T');
  return tool ? HeatTask::hotend_of(static_cast<std::size_t>(*tool)) : heat_.hotend();
}

// The row's own check is for the most that there may be.
bool HeatCommands::names_no_hotend(const ActiveCommand& command, Heater heater) const {
  return units::most_tools > 1 && heater == Heater::hotend && heat_.tools() == 1 &&
         command.command.integer('T').value_or(0) != 0;
}

Progress HeatCommands::set_temperature(ActiveCommand& command, Heater heater) {
  if (names_no_hotend(command, heater)) return command.refuse_tool();
  const auto value = command.value('S');
  return value ? take_target(command, heater, *value) : Progress::done;
}

Progress HeatCommands::take_target(ActiveCommand& command, Heater heater, std::int64_t millionths) {
  heater = heater_of(command, heater);
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
  const thermal::HeaterLoop& loop = heat_.loop(heater_of(command, heater));
  if (loop.at_target() || command.wait_cancelled) return Progress::done;
  const units::Milliseconds now = command.now.milliseconds;
  if (now >= next_report_) {
    host_link::TextLine line = heat_.report();
    host_link::add_waiting_time(line, whole_seconds(loop.time_to_arrival(now)));
    if (command.say(line) == Progress::done) next_report_ += report_period;
  }
  return Progress::again;
}

Progress HeatCommands::begin_to_wait(ActiveCommand& command, Heater heater) {
  if (names_no_hotend(command, heater)) return command.refuse_tool();
  const thermal::HeaterLoop& loop = heat_.loop(heater_of(command, heater));
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

// C counts before K and this before F, as in Marlin.
Progress HeatCommands::set_units(ActiveCommand& command) {
  unit_ = command.command.has('C')   ? Unit::celsius
          : command.command.has('K') ? Unit::kelvin
                                     : Unit::fahrenheit;
  return Progress::done;
}

// As Marlin does.
Progress HeatCommands::report_units(ActiveCommand& command) {
  static constexpr std::string_view names[]{"Celsius", "Fahrenheit", "Kelvin"};
  const std::string_view name = names[static_cast<std::size_t>(unit_)];
  host_link::TextLine line;
  return command.say(line.text("echo: M149 ").character(name[0]).text(" ; Units in ").text(name));
}

// Without P it is as S says: 0 allows all.
Progress HeatCommands::set_extrusion_limit(ActiveCommand& command) {
  if (const auto least = command.value('S')) heat_.set_least_extrusion(temperature_of(*least));
  const bool asked_for = command.integer('P').value_or(0) != 0;
  heat_.allow_cold_extrusion(asked_for || heat_.least_extrusion() == units::Millicelsius());
  return Progress::done;
}

// In Marlin's words.
Progress HeatCommands::report_extrusion_limit(ActiveCommand& command) {
  host_link::TextLine line;
  line.text("echo:Cold extrudes are ").text(heat_.cold_extrusion_allowed() ? "en"sv : "dis"sv);
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

}  // namespace application
