// SPDX-License-Identifier: Apache-2.0
// A machine as its description file in firmware/machines gives it to the simulation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "sim/devices/motor_driver.hpp"
#include "sim/machine/bed_surface.hpp"
#include "sim/machine/mechanism.hpp"
#include "sim/plants/heated_block.hpp"

namespace machine {

inline constexpr std::size_t axis_count = 4;  // x y z e, as in reports
inline constexpr std::array<char, axis_count> axis_letters{'x', 'y', 'z', 'e'};
inline constexpr std::size_t most_motors = axis_count + 1;

// Where motors are not the axes, steps and the driver are the motor's of the axis' name.
struct AxisDescription {
  double steps_per_mm{};
  std::optional<double> travel_mm;  // from the end stop to the far end; an extruder has none
  double max_speed_mm_s{};
  double max_acceleration_mm_s2{};
  double jerk_mm_s{};
  std::optional<std::size_t> end_stop;
  devices::DriverTiming driver;
};

// Of G10 and G11, until the file sets another; the defaults are those of the firmware.
struct RetractionDescription {
  double length_mm = 3;
  double lift_mm{};
  double extra_mm{};
};

// What the firmware takes up of the play of X, Y and Z.
struct BacklashDescription {
  std::array<double, 3> lengths_mm{};
  double correction = 1;  // the part of it
};

// What M701 and M702 move of the filament.
struct FilamentDescription {
  double load_mm{}, unload_mm{}, purge_mm{};
};

// Of the motor of X or Y.
struct ShaperDescription {
  std::string type = "none";  // as M593 P
  double frequency_hz{};
  double damping = 0.1;
};

// Input shaping and linear advance, until the file sets others.
struct ShapingDescription {
  std::array<ShaperDescription, 2> shapers;
  double advance_s{};
};

struct ProbeDescription {
  std::size_t input{};  // of the end stops
  // From the nozzle to where it measures; Z: the nozzle's where it touches the bed, from where the
  // probe triggers.
  std::array<double, 3> offset_mm{};
  double clearance_mm{};  // Z of the nozzle between two places
  // The mesh that it finds where G29 says no other: on X and Y.
  std::array<double, 2> mesh_from_mm{}, mesh_to_mm{};
  std::array<std::size_t, 2> mesh_points{};
  double fade_height_mm{};
};

struct HeaterDescription {
  std::size_t sensor_channel{};
  std::size_t heater_channel{};
  plants::HeatedBlockProperties block;
  double max_c{};
  double resistance_25c_ohms{};
  double beta_k{};
};

// A second extruder, on the carriage of the first.
struct ToolDescription {
  HeaterDescription hotend;
  std::array<double, 3> offset_mm{};  // of its nozzle from the first
  devices::DriverTiming driver;
  // What a change of tools does, until the file sets another.
  double swap_mm{}, resume_mm{}, prime_mm{}, lift_mm{};
};

struct ConverterDescription {
  double capacitor_nf{};
  double reference_low_ohms{};
  double reference_high_ohms{};
  double supply_v{};
  double threshold_v{};
};

struct Description {
  std::string name;
  std::uint32_t baud{};
  std::optional<std::uint32_t> memory_bytes;  // of the chip, where its firmware needs more
  std::array<AxisDescription, axis_count> axes;
  std::shared_ptr<const Mechanism> mechanism = cartesian_mechanism();
  RetractionDescription retraction;
  std::optional<BacklashDescription> backlash;
  std::optional<FilamentDescription> filament_change;
  std::optional<ShapingDescription> shaping;
  std::optional<ProbeDescription> probe;
  BedSurface bed_surface;  // flat without a table of it
  HeaterDescription hotend;
  HeaterDescription bed;
  ConverterDescription converter;
  std::optional<ToolDescription> second_tool;

  // The filament motor of a second extruder is behind those of the axes.
  std::size_t motors() const { return second_tool ? axis_count + 1 : axis_count; }
};

// Throws std::runtime_error with the file, the line and name of the entry and what is wrong with
// it: what the firmware cannot be built for is not simulated.
Description read_description(const std::filesystem::path& file);
// The same of a file's text; `name` is for the message.
Description parse_description(std::string_view text, const std::filesystem::path& name);

}  // namespace machine
