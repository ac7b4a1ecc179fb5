// SPDX-License-Identifier: Apache-2.0
// Writes the constants as designated initialisers of application::MachineDescription, in its units.
#include "machine_generator/header.hpp"

#include <fmt/format.h>

#include "machine_generator/description.hpp"
#include "machine_generator/kinematics_description.hpp"
#include "machine_generator/levelling_description.hpp"

namespace machine_generator {
namespace {

template <class Quantity>
std::string quantity(const char* type, Quantity value) {
  return fmt::format("units::{}{{{}}}", type, value.count());
}

std::string text(units::MicrometersPerSecond value) {
  return quantity("MicrometersPerSecond", value);
}
std::string text(units::MicrometersPerSecondSquared value) {
  return quantity("MicrometersPerSecondSquared", value);
}
std::string text(units::Nanometers value) { return quantity("Nanometers", value); }
std::string text(units::StepsPerMeter value) { return quantity("StepsPerMeter", value); }
std::string text(units::Millicelsius value) { return quantity("Millicelsius", value); }
std::string text(units::Milliohms value) { return quantity("Milliohms", value); }
std::string text(units::Milliseconds value) { return quantity("Milliseconds", value); }

std::string text(const motion::AxisLimits& axis) {
  std::string result = fmt::format(
      "          {{.steps_per_meter = {}, .travel = {},\n"
      "           .max_speed = {}, .max_acceleration = {},\n"
      "           .jerk = {}",
      text(axis.steps_per_meter), text(axis.travel), text(axis.max_speed),
      text(axis.max_acceleration), text(axis.jerk));
  if (axis.homing) {
    result += fmt::format(
        ",\n           .homing = motion::HomingParameters{{.fast_speed = {}, .slow_speed = {},\n"
        "                        .back_off = {}, .end_stop = {},\n"
        "                        .towards_positive = {}}}",
        text(axis.homing->fast_speed), text(axis.homing->slow_speed), text(axis.homing->back_off),
        axis.homing->end_stop, axis.homing->towards_positive);
  }
  return result + "},\n";
}

std::string text(const motion::Limits& limits) {
  std::string axes;
  for (const motion::AxisLimits& axis : limits.axes) axes += text(axis);
  return fmt::format(
      "{{\n      .axes = {{{{\n{}      }}}},\n      .print_acceleration = {},\n"
      "      .travel_acceleration = {},\n      .retract_acceleration = {},\n"
      "      .junction_deviation = {}, .min_cruise_percent = {}, .s_curve = {},\n"
      "      .retraction = {{.length = {}, .speed = {}, .lift = {},\n"
      "                     .extra = {}, .recovery_speed = {}}},\n  }}",
      axes, text(limits.print_acceleration), text(limits.travel_acceleration),
      text(limits.retract_acceleration), text(limits.junction_deviation), limits.min_cruise_percent,
      limits.s_curve, text(limits.retraction.length), text(limits.retraction.speed),
      text(limits.retraction.lift), text(limits.retraction.extra),
      text(limits.retraction.recovery_speed));
}

std::string text(const drivers::DriverChipTimings& driver) {
  return fmt::format(
      "drivers::DriverChipTimings{{.high_ns = {}, .low_ns = {}, .direction_setup_ns = {}, "
      ".direction_hold_ns = {}}}",
      driver.high_ns, driver.low_ns, driver.direction_setup_ns, driver.direction_hold_ns);
}

std::string text(const thermal::ControllerGains& gains) {
  return fmt::format(
      "{{.duty_per_celsius = {}, .duty_per_celsius_second = {},\n"
      "                       .duty_per_celsius_per_second = {}, .feed_forward_duty_per_celsius = "
      "{}}}",
      gains.duty_per_celsius, gains.duty_per_celsius_second, gains.duty_per_celsius_per_second,
      gains.feed_forward_duty_per_celsius);
}

std::string text(const thermal::HeaterProperties& model) {
  return fmt::format(
      "thermal::HeaterModel({{.rise = {}, .loss = {}, .fan_loss = {}, .filament_loss = {},\n"
      "                       .heater_lag = {}, .sensor_lag = {},\n"
      "                       .least_power = {}, .most_power = {}, .least_loss = {}, .most_loss = "
      "{},\n"
      "                       .draught = {}, .missing_limit = {}, .window = {}}})",
      model.rise, model.loss, model.fan_loss, model.filament_loss, text(model.heater_lag),
      text(model.sensor_lag), model.least_power, model.most_power, model.least_loss,
      model.most_loss, model.draught, text(model.missing_limit), text(model.window));
}

std::string text(const application::HeaterDescription& heater) {
  return fmt::format(
      "{{.sensor_channel = {}, .heater_channel = {},\n"
      "             .thermistor = {{.resistance_25c = {}, .beta_kelvin = {}}},\n"
      "             .min = {}, .max = {},\n"
      "             .gains = {},\n"
      "             .model = {}}}",
      heater.sensor_channel, heater.heater_channel, text(heater.thermistor.resistance_25c),
      heater.thermistor.beta_kelvin, text(heater.min), text(heater.max), text(heater.gains),
      text(heater.model));
}

std::string text(const application::ConverterDescription& converter) {
  return fmt::format(
      "{{.capacitor_picofarads = {}, .reference_low = {},\n"
      "                .reference_high = {}, .supply_millivolts = {}, .threshold_millivolts = {}}}",
      converter.capacitor_picofarads, text(converter.reference_low), text(converter.reference_high),
      converter.supply_millivolts, converter.threshold_millivolts);
}

std::string text(const motion::ShapingSettings& settings) {
  std::string shapers;
  for (const motion::Shaper& shaper : settings.shapers) {
    shapers += fmt::format(
        "motion::Shaper{{.type = motion::ShaperType{{{}}}, .millihertz = {}, .damping = {}}}, ",
        static_cast<int>(shaper.type), shaper.millihertz, shaper.damping);
  }
  return fmt::format(
      "motion::ShapingSettings{{\n      .shapers = {{{{{}}}}},\n      .advance_microseconds = {}}}",
      shapers, settings.advance_microseconds);
}

std::string text(const application::SecondTool& tool) {
  const application::ToolChange& change = tool.change;
  return fmt::format(
      "application::SecondTool{{\n      .hotend = {},\n      .offset = {{{}, {}, {}}},\n"
      "      .driver = {},\n"
      "      .change = {{.swap = {}, .resume = {}, .prime = {}, .lift = {},\n"
      "                 .prime_speed = {}, .retract_speed = {},\n"
      "                 .unretract_speed = {}}}}}",
      text(tool.hotend), text(tool.offset[0]), text(tool.offset[1]), text(tool.offset[2]),
      text(tool.driver), text(change.swap), text(change.resume), text(change.prime),
      text(change.lift), text(change.prime_speed), text(change.retract_speed),
      text(change.unretract_speed));
}

std::string header_of(const Machine& machine, const std::filesystem::path& file) {
  const application::MachineDescription& description = machine.description;
  std::string searches;
  for (const units::Nanometers search : description.homing_search) searches += text(search) + ", ";
  std::string drivers;
  for (const drivers::DriverChipTimings& driver : description.drivers) {
    drivers += "                  " + text(driver) + ",\n";
  }
  return fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Generated from {} by machine_generator: do not edit.\n"
      "#pragma once\n\n"
      "#include \"application/machine_description.hpp\"\n\n"
      "namespace machine {{\n\n{}{}"
      "inline constexpr application::MachineDescription machine{{\n"
      "  .name = \"{}\",\n{}  .baud = {},\n"
      "  .advanced_ok = {},\n  .host_silence = {},\n"
      "  .limits = {},\n{}"
      "  .homing_search = {{{{{}}}}},\n"
      "  .drivers = {{{{\n{}              }}}},\n"
      "  .hotend = {},\n  .bed = {},\n  .min_extrusion = {},\n"
      "  .converter = {},\n{}{}{}{}}};\n\n}}  // namespace machine\n",
      file.filename().string(), machine.levelling ? levelling_text(*machine.levelling) : "",
      parts_text(machine.parts), machine.name, description.fast ? "  .fast = true,\n" : "",
      description.baud, description.advanced_ok, text(description.host_silence),
      text(description.limits), kinematics_text(description.kinematics), searches, drivers,
      text(description.hotend), text(description.bed), text(description.min_extrusion),
      text(description.converter),
      description.shaping ? "  .shaping = " + text(*description.shaping) + ",\n" : "",
      machine.levelling ? "  .levelling = &levelling,\n" : "", parts_entries(machine.parts),
      description.second_tool ? "  .second_tool = " + text(*description.second_tool) + ",\n" : "");
}

}  // namespace

std::string header_of(const std::filesystem::path& file) {
  return header_of(read_machine(file), file);
}

std::string small_header_of(const std::filesystem::path& file) {
  Machine machine = read_machine(file);
  machine.description.fast = false;
  return header_of(machine, file);
}

void check(const toml::table& description, const std::filesystem::path& file) {
  read_machine(description, file);
}

}  // namespace machine_generator
