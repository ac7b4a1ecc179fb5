// SPDX-License-Identifier: Apache-2.0
// Writes the constants as designated initialisers of application::MachineDescription, in its units.
#include "machine_generator/header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
constexpr std::int64_t max_milliwatts = 10'000'000;

// M115 reports it in a line with other fields.
constexpr std::size_t longest_name = 64;
constexpr bool may_stand_in_name(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

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

// Energies and conductances become slopes: what full power does in a second, and what part of the
// difference to the surroundings is lost in one.
std::string model(Reader reader, double milliwatts) {
  constexpr std::int64_t million = 1'000'000;
  const auto milli = [&reader](const char* key, std::int64_t least) {
    return reader.scaled(key, thousand, least, two_billion);
  };
  const auto percent = [&reader](const char* key, std::int64_t least, std::int64_t most) {
    return reader.scaled(key, 100, least, most);
  };
  const auto rounded = [](double value) { return static_cast<std::int64_t>(std::llround(value)); };
  const auto heater = static_cast<double>(milli("heater_j_per_k", 1));
  const auto block = static_cast<double>(milli("block_j_per_k", 1));
  const auto through = static_cast<double>(milli("heater_to_block_w_per_k", 1));
  const double all = heater + block;
  constexpr double steepest_milliwatts = 6.0;  // per mJ/K: what 32 bits hold in the comparison
  if (milliwatts / all > steepest_milliwatts) {
    reader.fail("block_j_per_k", "is so small that full power heats by more than 6 K/s");
  }
  const auto part_per_second = [&](double milliwatts_per_kelvin) {
    return rounded(milliwatts_per_kelvin / all * million);
  };
  // PLA, from room temperature: 1.24 g/cm^3, about 1.9 J/(g K), filament of 1.75 mm.
  constexpr double joules_per_mm_kelvin = 1.24e-3 * 1.9 * 2.405;
  const std::string text = fmt::format(
      "thermal::HeaterModel({{.rise = {}, .loss = {}, .fan_loss = {}, .filament_loss = {},\n"
      "                       .heater_lag = {}, .sensor_lag = {},\n"
      "                       .least_power = {}, .most_power = {}, .least_loss = {}, .most_loss = "
      "{},\n"
      "                       .draught = {}, .missing_limit = {}, .window = {}}})",
      rounded(milliwatts / all * thousand),
      part_per_second(static_cast<double>(milli("loss_w_per_k", 0))),
      part_per_second(static_cast<double>(milli("fan_loss_w_per_k", 0))),
      part_per_second(reader.truth("melts_filament") ? joules_per_mm_kelvin * thousand : 0),
      quantity("Milliseconds", rounded(heater * block / all / through * thousand)),
      quantity("Milliseconds", milli("sensor_lag_s", 1)), percent("power_least", 1, 100),
      percent("power_most", 100, 400), percent("loss_least", 1, 100),
      percent("loss_most", 100, 400), percent("draught", 0, 200),
      quantity("Millicelsius", reader.scaled("missing_limit_k", thousand, 1, 16'000)),
      quantity("Milliseconds", reader.scaled("window_s", thousand, 100, 60'000)));
  reader.finish();
  return text;
}

std::string heater(Reader& reader, Reader& thermistors) {
  const std::int64_t channels = thermal_channels;
  const auto milliwatts =
      static_cast<double>(reader.scaled("heater_watts", thousand, 1, max_milliwatts));
  if (reader.scaled("min_c", thousand, -max_millicelsius, max_millicelsius) >=
      reader.scaled("max_c", thousand, -max_millicelsius, max_millicelsius)) {
    reader.fail("min_c", "must be below max_c");
  }
  const std::string kind = reader.text("thermistor");
  if (!thermistors.has(kind)) reader.fail("thermistor", "names none of [thermistors]");
  return fmt::format(
      "{{.sensor_channel = {}, .heater_channel = {},\n"
      "             .thermistor = {},\n"
      "             .min = {}, .max = {},\n"
      "             .gains = {},\n"
      "             .model = {}}}",
      reader.whole("sensor_channel", 0, channels - 1),
      reader.whole("heater_channel", 0, channels - 1), thermistor(thermistors.table(kind)),
      celsius(reader, "min_c"), celsius(reader, "max_c"), gains(reader.table("control")),
      model(reader.table("model"), milliwatts));
}

// Two equal references define no line, and a capacitor never reaches the supply.
std::string converter(Reader reader) {
  if (reader.scaled("reference_low_ohms", thousand, 1, max_milliohms) >=
      reader.scaled("reference_high_ohms", thousand, 1, max_milliohms)) {
    reader.fail("reference_low_ohms", "must be below reference_high_ohms");
  }
  if (reader.scaled("threshold_v", thousand, 1, two_billion) >=
      reader.scaled("supply_v", thousand, 1, two_billion)) {
    reader.fail("threshold_v", "must be below supply_v");
  }
  const std::string text = fmt::format(
      "{{.capacitor_picofarads = {}, .reference_low = {},\n"
      "                .reference_high = {}, .supply_millivolts = {}, .threshold_millivolts = {}}}",
      reader.scaled("capacitor_nf", thousand, 1, two_billion), ohms(reader, "reference_low_ohms"),
      ohms(reader, "reference_high_ohms"), reader.scaled("supply_v", thousand, 1, two_billion),
      reader.scaled("threshold_v", thousand, 1, two_billion));
  reader.finish();
  return text;
}

std::string header_of(const toml::table& table, const std::filesystem::path& file) {
  Reader root(file, table);
  const std::string name = root.text("name");
  if (name.size() > longest_name || !std::ranges::all_of(name, may_stand_in_name)) {
    root.fail("name", "is longer than 64 bytes, or holds \", \\ or what is not printable ASCII");
  }
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
  std::string searches;
  std::int64_t used_end_stops = 0;
  for (const char* letter : {"x", "y", "z", "e"}) {
    Reader axis = axes.table(letter);
    const bool bounded = letter[0] != 'e';
    limits += axis_limits(axis, bounded);
    const std::string chip = axis.text("driver");
    if (!driver_chips.has(chip)) axis.fail("driver", "names none of [drivers]");
    drivers += "                  drivers::DriverChipTimings" +
               driver_timings(driver_chips.table(chip)) + ",\n";
    const char* search = axis.has("homing_search_mm") ? "homing_search_mm" : "travel_mm";
    searches += bounded ? length(axis, search, 1) + ", " : quantity("Nanometers", 0);
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
  for (const char* channel : {"sensor_channel", "heater_channel"}) {
    if (hotend.whole(channel, 0, thermal_channels - 1) ==
        bed.whole(channel, 0, thermal_channels - 1)) {
      bed.fail(channel, "is the channel of another heater already");
    }
  }
  const std::string min_extrusion = celsius(hotend, "min_extrusion_c");
  if (hotend.scaled("min_extrusion_c", thousand, -max_millicelsius, max_millicelsius) >
      hotend.scaled("max_c", thousand, -max_millicelsius, max_millicelsius)) {
    hotend.fail("min_extrusion_c", "must not be above max_c");
  }
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
      "  .homing_search = {{{{{}}}}},\n"
      "  .drivers = {{{{\n{}              }}}},\n"
      "  .hotend = {},\n  .bed = {},\n  .min_extrusion = {},\n"
      "  .converter = {},\n}};\n\n}}  // namespace machine\n",
      file.filename().string(), name, baud, advanced_ok,
      quantity("Milliseconds", thousand * host_silence), limits, accelerations, searches, drivers,
      hotend_text, bed_text, min_extrusion, converter_text);
}

}  // namespace

std::string header_of(const std::filesystem::path& file) {
  return header_of(Reader::parse(file), file);
}

void check(const toml::table& description, const std::filesystem::path& file) {
  header_of(description, file);
}

}  // namespace machine_generator
