// SPDX-License-Identifier: Apache-2.0
// Writes the constants as designated initialisers of application::MachineDescription, in its units.
#include "machine_generator/header.hpp"

#include <fmt/format.h>

#include "machine_generator/reader.hpp"

namespace machine_generator {
namespace {

// Bounds are those of the firmware's arithmetic (motion/limits.hpp), or of the registers.
constexpr std::int64_t thousand = 1000;
constexpr std::int64_t nanometers_per_mm = 1'000'000;
constexpr std::int64_t max_steps_per_meter = 10'000'000;
constexpr std::int64_t max_travel_nanometers = 100'000'000'000;
constexpr std::int64_t max_speed = 10'000'000;
constexpr std::int64_t max_acceleration = 100'000'000;
constexpr std::int64_t max_driver_ns = 100'000;
constexpr std::int64_t max_millicelsius = 1'000'000;
constexpr std::int64_t max_milliohms = 1'000'000'000'000;
constexpr std::int64_t end_stop_inputs = 8;
constexpr std::int64_t thermal_channels = 4;
constexpr std::int64_t max_silence_seconds = 24 * 3600;
constexpr std::int64_t two_billion = 2'000'000'000;

std::string quantity(const char* type, std::int64_t value) {
  return fmt::format("units::{}{{{}}}", type, value);
}

std::string speed(Reader& reader, const char* key, std::int64_t least) {
  return quantity("MicrometersPerSecond", reader.scaled(key, thousand, least, max_speed));
}

std::string acceleration(Reader& reader, const char* key) {
  return quantity("MicrometersPerSecondSquared", reader.scaled(key, thousand, 1, max_acceleration));
}

std::string length(Reader& reader, const char* key, std::int64_t least) {
  return quantity("Nanometers",
                  reader.scaled(key, nanometers_per_mm, least, max_travel_nanometers));
}

std::string celsius(Reader& reader, const char* key) {
  return quantity("Millicelsius",
                  reader.scaled(key, thousand, -max_millicelsius, max_millicelsius));
}

std::string ohms(Reader& reader, const char* key) {
  return quantity("Milliohms", reader.scaled(key, thousand, 1, max_milliohms));
}

std::string homing(Reader& axis) {
  return fmt::format(
      ".homing = motion::HomingParameters{{.fast_speed = {}, .slow_speed = {},\n"
      "                        .back_off = {}, .end_stop = {}}}",
      speed(axis, "homing_speed_mm_s", 1), speed(axis, "homing_slow_speed_mm_s", 1),
      length(axis, "homing_backoff_mm", 1), axis.whole("endstop", 0, end_stop_inputs - 1));
}

std::string axis_limits(Reader& axis, bool bounded) {
  std::string text = fmt::format(
      "          {{.steps_per_meter = {}, .travel = {},\n"
      "           .max_speed = {}, .max_acceleration = {},\n"
      "           .jerk = {}",
      quantity("StepsPerMeter", axis.scaled("steps_per_mm", thousand, 1, max_steps_per_meter)),
      bounded ? length(axis, "travel_mm", 1) : quantity("Nanometers", 0),
      speed(axis, "max_speed_mm_s", 1), acceleration(axis, "max_acceleration_mm_s2"),
      speed(axis, "jerk_mm_s", 0));
  if (bounded) text += ",\n           " + homing(axis);
  return text + "},\n";
}

std::string driver_timings(Reader driver) {
  const auto time = [&driver](const char* key) { return driver.whole(key, 0, max_driver_ns); };
  const std::string text = fmt::format(
      "{{.high_ns = {}, .low_ns = {}, .direction_setup_ns = {}, .direction_hold_ns = {}}}",
      time("high_ns"), time("low_ns"), time("direction_setup_ns"), time("direction_hold_ns"));
  driver.finish();
  return text;
}

std::string thermistor(Reader reader) {
  const std::string text =
      fmt::format("{{.resistance_25c = {}, .beta_kelvin = {}}}",
                  ohms(reader, "resistance_25c_ohms"), reader.scaled("beta_k", 1, 1, 100'000));
  reader.finish();
  return text;
}

// Gains are given as parts of full power and kept as parts of 65535.
std::string gains(Reader reader) {
  const auto duty = [&reader](const char* key) {
    constexpr std::int64_t million = 1'000'000, full_duty = 65'535;
    return (reader.scaled(key, million, 0, 1'000 * million) * full_duty + million / 2) / million;
  };
  const std::string text = fmt::format(
      "{{.duty_per_celsius = {}, .duty_per_celsius_second = {},\n"
      "                       .duty_per_celsius_per_second = {}, .feed_forward_duty_per_celsius = "
      "{}}}",
      duty("proportional_per_c"), duty("integral_per_c_s"), duty("derivative_s_per_c"),
      duty("feed_forward_per_c"));
  reader.finish();
  return text;
}

std::string heater(Reader& reader, Reader& thermistors) {
  const std::int64_t channels = thermal_channels;
  reader.leave("heater_watts");
  const std::string kind = reader.text("thermistor");
  if (!thermistors.has(kind)) reader.fail("thermistor", "names none of [thermistors]");
  return fmt::format(
      "{{.sensor_channel = {}, .heater_channel = {},\n"
      "             .thermistor = {},\n"
      "             .min = {}, .max = {},\n"
      "             .gains = {}}}",
      reader.whole("sensor_channel", 0, channels - 1),
      reader.whole("heater_channel", 0, channels - 1), thermistor(thermistors.table(kind)),
      celsius(reader, "min_c"), celsius(reader, "max_c"), gains(reader.table("control")));
}

std::string converter(Reader reader) {
  const std::string text = fmt::format(
      "{{.capacitor_picofarads = {}, .reference_low = {},\n"
      "                .reference_high = {}, .supply_millivolts = {}, .threshold_millivolts = {}}}",
      reader.scaled("capacitor_nf", thousand, 1, two_billion), ohms(reader, "reference_low_ohms"),
      ohms(reader, "reference_high_ohms"), reader.scaled("supply_v", thousand, 1, two_billion),
      reader.scaled("threshold_v", thousand, 1, two_billion));
  reader.finish();
  return text;
}

}  // namespace

std::string header_of(const std::filesystem::path& file) {
  const toml::table table = Reader::parse(file);
  Reader root(file, table);
  const std::string name = root.text("name");
  if (name.find_first_of("\"\\\n") != std::string::npos)
    root.fail("name", "holds \", \\ or a line end");
  if (root.text("kinematics") != "cartesian") root.fail("kinematics", "must be \"cartesian\"");

  Reader serial = root.table("serial");
  const std::int64_t baud = serial.whole("baud", 1200, 10'000'000);
  const bool advanced_ok = serial.truth("advanced_ok");
  const std::int64_t host_silence = serial.whole("host_silence_s", 0, max_silence_seconds);
  serial.finish();

  Reader axes = root.table("axes");
  Reader driver_chips = root.table("drivers");
  std::string limits;
  std::string drivers;
  std::int64_t used_end_stops = 0;
  for (const char* letter : {"x", "y", "z", "e"}) {
    Reader axis = axes.table(letter);
    const bool bounded = letter[0] != 'e';
    limits += axis_limits(axis, bounded);
    const std::string chip = axis.text("driver");
    if (!driver_chips.has(chip)) axis.fail("driver", "names none of [drivers]");
    drivers += "                  drivers::DriverChipTimings" +
               driver_timings(driver_chips.table(chip)) + ",\n";
    if (bounded) {
      const std::int64_t bit = std::int64_t{1} << axis.whole("endstop", 0, end_stop_inputs - 1);
      if ((used_end_stops & bit) != 0) axis.fail("endstop", "is the input of another axis already");
      used_end_stops |= bit;
    }
    axis.finish();
  }
  axes.finish();

  Reader motion = root.table("motion");
  const std::string accelerations = fmt::format(
      "      .print_acceleration = {},\n      .travel_acceleration = {},\n      "
      ".retract_acceleration = {},\n",
      acceleration(motion, "acceleration_mm_s2"), acceleration(motion, "travel_acceleration_mm_s2"),
      acceleration(motion, "retract_acceleration_mm_s2"));
  motion.finish();

  Reader thermistors = root.table("thermistors");
  Reader hotend = root.table("hotend");
  Reader bed = root.table("bed");
  const std::string hotend_text = heater(hotend, thermistors);
  const std::string bed_text = heater(bed, thermistors);
  const std::string min_extrusion = celsius(hotend, "min_extrusion_c");
  const std::string converter_text = converter(root.table("temperature_converter"));
  for (const Reader* reader : {&hotend, &bed}) reader->finish();
  root.finish();

  return fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Generated from {} by machine_generator: do not edit.\n"
      "#pragma once\n\n"
      "#include \"application/machine_description.hpp\"\n\n"
      "namespace machine {{\n\n"
      "inline constexpr application::MachineDescription machine{{\n"
      "  .name = \"{}\",\n  .baud = {},\n"
      "  .advanced_ok = {},\n  .host_silence = {},\n"
      "  .limits = {{\n      .axes = {{{{\n{}      }}}},\n{}  }},\n"
      "  .drivers = {{{{\n{}              }}}},\n"
      "  .hotend = {},\n  .bed = {},\n  .min_extrusion = {},\n"
      "  .converter = {},\n}};\n\n}}  // namespace machine\n",
      file.filename().string(), name, baud, advanced_ok,
      quantity("Milliseconds", thousand * host_silence), limits, accelerations, drivers,
      hotend_text, bed_text, min_extrusion, converter_text);
}

}  // namespace machine_generator
