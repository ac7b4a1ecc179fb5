// SPDX-License-Identifier: Apache-2.0
// Reads every entry with its type and range, in the firmware's units.
#include "machine_generator/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drivers/uart.hpp"
#include "machine_generator/heater_description.hpp"
#include "machine_generator/kinematics_description.hpp"
#include "machine_generator/levelling_description.hpp"
#include "machine_generator/reader.hpp"

namespace machine_generator {
namespace {

// Bounds are those of the firmware's arithmetic (motion/limits.hpp), or of the registers.
constexpr std::int64_t thousand = 1000;
constexpr std::int64_t nanometers_per_mm = 1'000'000;
constexpr std::int64_t max_travel_nanometers = 100'000'000'000;
constexpr std::int64_t farthest_offset_nanometers = 1'000'000'000;
constexpr std::int64_t max_driver_ns = 100'000;
constexpr std::int64_t end_stop_inputs = 8;
constexpr std::int64_t least_memory_kib = 64, most_memory_kib = 256;
constexpr std::int64_t least_clock_mhz = 4, most_clock_mhz = 200;
constexpr std::int64_t max_silence_seconds = 24 * 3600;
constexpr const char* s_curve_key = "s_curve_acceleration";

// M115 reports it in a line with other fields.
constexpr std::size_t longest_name = 64;
constexpr bool may_stand_in_name(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }

units::MicrometersPerSecond speed(Reader& reader, const char* key, std::int64_t least) {
  return quantity<units::MicrometersPerSecond>(
      reader.scaled(key, thousand, least, motion::max_speed.count()));
}

units::MicrometersPerSecondSquared acceleration(Reader& reader, const char* key) {
  return quantity<units::MicrometersPerSecondSquared>(
      reader.scaled(key, thousand, 1, motion::max_acceleration.count()));
}

units::Nanometers length(Reader& reader, const char* key) {
  return units::Nanometers(reader.scaled(key, nanometers_per_mm, 1, max_travel_nanometers));
}

motion::HomingParameters homing(Reader& axis) {
  return {.fast_speed = speed(axis, "homing_speed_mm_s", 1),
          .slow_speed = speed(axis, "homing_slow_speed_mm_s", 1),
          .back_off = length(axis, "homing_backoff_mm"),
          .end_stop = static_cast<std::uint8_t>(axis.whole("endstop", 0, end_stop_inputs - 1))};
}

motion::AxisLimits axis_limits(Reader& axis, bool bounded) {
  motion::AxisLimits limits{.steps_per_meter = quantity<units::StepsPerMeter>(axis.scaled(
                                "steps_per_mm", thousand, 1, motion::max_steps_per_meter.count())),
                            .max_speed = speed(axis, "max_speed_mm_s", 1),
                            .max_acceleration = acceleration(axis, "max_acceleration_mm_s2"),
                            .jerk = speed(axis, "jerk_mm_s", 0)};
  if (!bounded) return limits;
  limits.travel = length(axis, "travel_mm");
  limits.homing = homing(axis);
  return limits;
}

drivers::DriverChipTimings driver_timings(Reader driver) {
  const auto time = [&driver](const char* key) {
    return static_cast<std::uint32_t>(driver.whole(key, 0, max_driver_ns));
  };
  const drivers::DriverChipTimings timings{.high_ns = time("high_ns"),
                                           .low_ns = time("low_ns"),
                                           .direction_setup_ns = time("direction_setup_ns"),
                                           .direction_hold_ns = time("direction_hold_ns")};
  driver.finish();
  return timings;
}

drivers::DriverChipTimings driver_of(Reader& motor, Reader& driver_chips) {
  const std::string chip = motor.text("driver");
  if (!driver_chips.has(chip)) motor.fail("driver", "names none of [drivers]");
  return driver_timings(driver_chips.table(chip));
}

void read_serial(Reader serial, application::MachineDescription& machine) {
  machine.baud = static_cast<std::uint32_t>(serial.whole("baud", 1200, 10'000'000));
  machine.advanced_ok = serial.truth("advanced_ok");
  machine.host_silence =
      units::Milliseconds(thousand * serial.whole("host_silence_s", 0, max_silence_seconds));
  serial.finish();
}

void read_axes(Reader axes, Reader driver_chips, application::MachineDescription& machine) {
  std::uint32_t used_end_stops = 0;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const char letter = static_cast<char>(units::axis_letters[i] - 'A' + 'a');
    const bool bounded = letter != 'e';
    Reader axis = axes.table(std::string(1, letter));
    motion::AxisLimits& limits = machine.limits.axes[i];
    limits = axis_limits(axis, bounded);
    machine.drivers[i] = driver_of(axis, driver_chips);
    const char* search = axis.has("homing_search_mm") ? "homing_search_mm" : "travel_mm";
    if (bounded) {
      machine.homing_search[i] = length(axis, search);
      const std::uint32_t bit = 1u << limits.homing->end_stop;
      if ((used_end_stops & bit) != 0) axis.fail("endstop", "is the input of another axis already");
      used_end_stops |= bit;
    }
    axis.finish();
  }
  axes.finish();
}

void read_motion(Reader motion, motion::Limits& limits) {
  limits.print_acceleration = acceleration(motion, "acceleration_mm_s2");
  limits.travel_acceleration = acceleration(motion, "travel_acceleration_mm_s2");
  limits.retract_acceleration = acceleration(motion, "retract_acceleration_mm_s2");
  if (motion.has("junction_deviation_mm")) {
    limits.junction_deviation = units::Nanometers(motion.scaled(
        "junction_deviation_mm", nanometers_per_mm, 0, motion::max_junction_deviation.count()));
  }
  if (motion.has("minimum_cruise_ratio")) {
    limits.min_cruise_percent =
        static_cast<std::uint8_t>(motion.scaled("minimum_cruise_ratio", 100, 0, 99));
  }
  if (motion.has(s_curve_key)) limits.s_curve = motion.truth(s_curve_key);
  motion.finish();
}

// What makes segments of its own of a line, or many lines of one, would cut its ramps.
void check_s_curve(Reader& root, const application::MachineDescription& machine) {
  if (!machine.limits.s_curve) return;
  const Reader motion = root.table("motion");
  if (machine.shaping) motion.fail(s_curve_key, "cannot be true in a machine with [shaping]");
  if (!motion::kinematics::Any(machine.kinematics).straight()) {
    motion.fail(s_curve_key, "cannot be true with these kinematics: each chord would be a ramp");
  }
}

// Of G10 and G11; a machine without the table has Marlin's values.
void read_retraction(Reader table, motion::Retraction& retraction) {
  const auto length = [&table](const char* key, std::int64_t least) {
    return units::Nanometers(
        table.scaled(key, nanometers_per_mm, least, motion::max_retraction.count()));
  };
  retraction = {.length = length("length_mm", 0),
                .speed = speed(table, "speed_mm_s", 1),
                .lift = length("lift_mm", 0),
                .extra = length("extra_mm", -motion::max_retraction.count()),
                .recovery_speed = speed(table, "recovery_speed_mm_s", 1)};
  table.finish();
}

// The second extruder but for its heater.
application::SecondTool read_second_tool(Reader tool, Reader change, Reader driver_chips) {
  application::SecondTool second;
  const auto offset = tool.scaled_list("offset_mm", nanometers_per_mm, -farthest_offset_nanometers,
                                       farthest_offset_nanometers, second.offset.size());
  for (std::size_t i = 0; i < offset.size(); ++i) second.offset[i] = units::Nanometers(offset[i]);
  second.driver = driver_of(tool, driver_chips);
  tool.table("hotend");
  tool.finish();
  const auto length = [&change](const char* key, std::int64_t least_mm, std::int64_t most_mm) {
    return units::Nanometers(change.scaled(key, nanometers_per_mm, least_mm * nanometers_per_mm,
                                           most_mm * nanometers_per_mm));
  };
  // Marlin's bounds of M217.
  second.change = {.swap = length("swap_length_mm", 0, 200),
                   .resume = length("resume_extra_mm", -10, 10),
                   .prime = length("prime_length_mm", 0, 200),
                   .lift = length("lift_mm", 0, 200),
                   .prime_speed = speed(change, "prime_speed_mm_s", 1),
                   .retract_speed = speed(change, "retract_speed_mm_s", 1),
                   .unretract_speed = speed(change, "unretract_speed_mm_s", 1)};
  change.finish();
  return second;
}

motion::Shaper read_shaper(Reader table) {
  motion::Shaper shaper;
  const std::string name = table.text("type");
  const auto type = std::ranges::find(motion::shaper_names, name);
  if (type == motion::shaper_names.end()) {
    table.fail("type", "is none of none, zv, zvd, mzv, ei, 2hump_ei");
  }
  shaper.type = static_cast<motion::ShaperType>(type - motion::shaper_names.begin());
  if (shaper.type != motion::ShaperType::none) {
    shaper.millihertz = static_cast<std::uint32_t>(
        table.scaled("frequency_hz", thousand, motion::least_millihertz, motion::most_millihertz));
    shaper.damping = static_cast<std::uint32_t>(
        table.scaled("damping", motion::damping_one, 0, motion::most_damping));
  }
  table.finish();
  return shaper;
}

// Its presence alone fits shaping and linear advance into the image.
void read_shaping(Reader table, motion::ShapingSettings& settings) {
  if (table.has("x")) settings.shapers[0] = read_shaper(table.table("x"));
  if (table.has("y")) settings.shapers[1] = read_shaper(table.table("y"));
  settings.advance_microseconds = static_cast<std::uint32_t>(
      table.scaled("advance_s", 1'000'000, 0, motion::most_advance_microseconds));
  table.finish();
}

// Whether the firmware meets its deadlines with it only its image shows (tools/timing).
std::uint32_t read_clock(Reader& root, std::uint32_t baud) {
  constexpr std::int64_t hz_per_mhz = 1'000'000;
  const auto hz = static_cast<std::uint32_t>(root.scaled(
      "clock_mhz", hz_per_mhz, least_clock_mhz * hz_per_mhz, most_clock_mhz * hz_per_mhz));
  if (!drivers::Uart::increment(baud, units::Hertz(hz))) {
    root.fail("clock_mhz", fmt::format("is too slow for a serial line of {} baud, which needs 4 "
                                       "clocks for each bit: {} at least, or a slower line",
                                       baud, 4.0 * baud / hz_per_mhz));
  }
  return hz;
}

}  // namespace

Machine read_machine(const toml::table& table, const std::filesystem::path& file) {
  Machine machine;
  Reader root(file, table);
  machine.name = root.text("name");
  if (machine.name.size() > longest_name || !std::ranges::all_of(machine.name, may_stand_in_name)) {
    root.fail("name", "is longer than 64 bytes, or holds \", \\ or what is not printable ASCII");
  }
  if (root.has("memory_kib")) {
    // Up to what the largest board holds, in whole block RAMs for 32 bits.
    const std::int64_t kib = root.whole("memory_kib", least_memory_kib, most_memory_kib);
    if (kib % 4 != 0) root.fail("memory_kib", "must be a multiple of 4");
    machine.memory_bytes = static_cast<std::uint32_t>(kib * 1024);
    machine.description.fast = machine.memory_bytes >= application::fast_memory_bytes;
  }
  read_serial(root.table("serial"), machine.description);
  if (root.has("clock_mhz")) machine.clock_hz = read_clock(root, machine.description.baud);
  read_axes(root.table("axes"), root.table("drivers"), machine.description);
  read_kinematics(root, machine.description);
  read_motion(root.table("motion"), machine.description.limits);
  if (root.has("retraction")) {
    read_retraction(root.table("retraction"), machine.description.limits.retraction);
  }
  if (root.has("shaping")) {
    read_shaping(root.table("shaping"), machine.description.shaping.emplace());
  }
  check_s_curve(root, machine.description);
  machine.levelling = read_levelling(root, machine.description);
  machine.parts = read_parts(root, machine.description, machine.levelling);
  if (root.has("tool_1")) {
    machine.description.second_tool =
        read_second_tool(root.table("tool_1"), root.table("tool_change"), root.table("drivers"));
  }
  read_heaters(root, machine.description);
  root.finish();
  return machine;
}

application::MachineDescription Machine::whole() const {
  application::MachineDescription all = description;
  all.name = name;
  if (levelling) all.levelling = &*levelling;
  if (parts.backlash) all.backlash = &*parts.backlash;
  if (parts.filament_sensor) all.filament_sensor = &*parts.filament_sensor;
  if (parts.filament_change) all.filament_change = &*parts.filament_change;
  return all;
}

Machine read_machine(const std::filesystem::path& file) {
  return read_machine(Reader::parse(file), file);
}

}  // namespace machine_generator
