// SPDX-License-Identifier: Apache-2.0
// The letters that commands take, for the rows of the table of commands.
#pragma once

#include "application/gcode_row.hpp"
#include "drivers/fan.hpp"
#include "host_link/emergency.hpp"
#include "motion/limits.hpp"

namespace application {

// In an image for one extruder there is none of these commands.
template <auto method>
constexpr Handler of_tools =
    units::most_tools == 1 ? handler<&HostCommands::report_not_fitted> : handler<method>;

// In an image for other kinematics there is none of these.
inline constexpr bool may_be_delta = motion::kinematics::Chosen::may_be_delta;
template <auto method>
constexpr Handler of_delta =
    may_be_delta ? handler<method> : handler<&HostCommands::report_not_fitted>;
inline constexpr Conduct of_delta_report =
    may_be_delta
        ? Conduct{.start = Start::at_rest, .report = handler<&SettingCommands::report_geometry>}
        : Conduct{};

namespace gcode_arguments {

inline constexpr std::int32_t day_s = 24 * 3600;
inline constexpr std::int32_t largest_factor = host_link::largest_speed_factor;
inline constexpr std::int32_t most_mm_per_s = motion::max_speed.count() / 1000;
inline constexpr std::int32_t most_mm_per_s2 = motion::max_acceleration.count() / 1000;
inline constexpr std::int32_t most_steps_per_mm = motion::max_steps_per_meter.count() / 1000;

inline constexpr Arguments move{strict_numbers("XYZE", "mm"), strict_numbers("F", "mm/min")};
inline constexpr Arguments arc{strict_numbers("XYZEIJKR", "mm"), strict_numbers("F", "mm/min")};
inline constexpr Arguments position{strict_numbers("XYZE", "mm"), numbers("F", no_effect)};
inline constexpr Arguments parking{clamped("P", "", 0, 2)};
inline constexpr Arguments slot{refused("S", "", 0, PlaceCommands::slots - 1)};
inline constexpr Arguments saved_place{numbers("XYZ", "mm"), flags("E"), numbers("F", "mm/min"),
                                       refused("S", "", 0, PlaceCommands::slots - 1)};
inline constexpr Arguments babystep{numbers("ZS", "mm")};
// Where there is one tool, T is not looked at.
inline constexpr Arguments filament =
    units::most_tools > 1 ? Arguments{numbers("D", "mm"), numbers("S", ""), hotend_of_tool("T")}
                          : Arguments{numbers("D", "mm"), numbers("S", "")};
inline constexpr Arguments home_offset{numbers("XYZ", "mm")};
inline constexpr Arguments homing{flags("XYZ"), numbers("EORW", no_effect)};
inline constexpr Arguments axes{flags("XYZE")};
inline constexpr Arguments motors_off{flags("XYZE"), clamped("S", "s", 0, day_s)};
inline constexpr Arguments time{clamped("P", "ms", 0, day_s * 1000), clamped("S", "s", 0, day_s)};
inline constexpr Arguments question{clamped("P", "ms", 0, day_s * 1000),
                                    clamped("S", "s", 0, day_s), text("text")};
inline constexpr Arguments interval{clamped("S", "s", 0, 60)};
inline constexpr Arguments silence{clamped("S", "s", 0, day_s)};
inline constexpr Arguments hotend{numbers("S", "°C"), hotend_of_tool("T")};
inline constexpr Arguments hotend_wait{numbers("SR", "°C"), hotend_of_tool("T")};
inline constexpr Arguments bed{numbers("S", "°C")};
inline constexpr Arguments bed_wait{numbers("SR", "°C")};
inline constexpr Arguments fan{clamped("S", "", 0, drivers::Fan::full_duty),
                               numbers("P", "(fan 0)")};
inline constexpr Arguments other_fan{numbers("P", "(fan 0)")};
inline constexpr Arguments steps{numbers("XYZE", "steps/mm", most_steps_per_mm)};
inline constexpr Arguments axis_accelerations{numbers("XYZE", "mm/s²", most_mm_per_s2)};
inline constexpr Arguments axis_speeds{numbers("XYZE", "mm/s", most_mm_per_s)};
inline constexpr Arguments accelerations{numbers("PTRS", "mm/s²", most_mm_per_s2)};
inline constexpr Arguments advanced{numbers("XYZEST", "mm/s", most_mm_per_s), numbers("J", "mm", 1),
                                    numbers("B", no_effect)};
inline constexpr Arguments retraction_move{numbers("S", no_effect)};
inline constexpr Arguments retraction{numbers("SZ", "mm"), numbers("F", "mm/min"),
                                      numbers("W", no_effect)};
inline constexpr Arguments recovery{numbers("S", "mm"), numbers("F", "mm/min"),
                                    numbers("WR", no_effect)};
inline constexpr Arguments automatic_retraction{numbers("S", "", 1)};
inline constexpr Arguments pressure_advance{numbers("S", "s", 10), numbers("D", "(extruder 0)")};
inline constexpr Arguments linear_advance{numbers("K", "s", 10), numbers("TLS", no_effect)};
inline constexpr Arguments shapers{flags("XY"), numbers("F", "Hz", 500), numbers("DS", "of 1"),
                                   numbers("P", "\"type\"")};
inline constexpr Arguments speed_factor{refused("S", "%", 1, largest_factor), flags("BR")};
inline constexpr Arguments flow_factor =
    units::most_tools > 1 ? Arguments{refused("S", "%", 1, largest_factor), hotend_of_tool("T")}
                          : Arguments{refused("S", "%", 1, largest_factor)};
inline constexpr Arguments tool_change =
    units::most_tools > 1 ? Arguments{numbers("SBEZ", "mm"), numbers("PRU", "mm/min"), flags("Q")}
                          : Arguments{};
inline constexpr Arguments tool_offset =
    units::most_tools > 1 ? Arguments{hotend_of_tool("T"), numbers("XYZ", "mm")} : Arguments{};
inline constexpr Arguments tool_mode =
    units::most_tools > 1 ? Arguments{numbers("S", "mode")} : Arguments{};
inline constexpr Arguments line_number{numbers("N", "number")};
inline constexpr Arguments repeats{numbers("L", "times")};
inline constexpr Arguments answer{numbers("S", "button")};
inline constexpr Arguments simulation{numbers("S", "mode"), flags("P")};
inline constexpr Arguments debug_bits{clamped("S", "bits", 0, 255)};
inline constexpr Arguments progress{clamped("P", "%", 0, 100), clamped("R", "min", 0, 65535),
                                    numbers("CQDS", no_effect)};
inline constexpr Arguments soft_limits{refused("S", "", 0, 1)};
inline constexpr Arguments temperature_units{flags("CFK")};
inline constexpr Arguments statistics{numbers("S", "78")};
inline constexpr Arguments tone{numbers("PS", no_effect)};
inline constexpr Arguments extrusion_limit{numbers("S", "°C"), flags("P")};
inline constexpr Arguments printer_check{numbers("PQ", no_effect)};
inline constexpr Arguments object{text("T, S or A")};
inline constexpr Arguments grid{numbers("LRFB", "mm"), numbers("XY", "points"),
                                numbers("S", "mm/min"), numbers("V", "mode")};
inline constexpr Arguments probed_place{numbers("XY", "mm"), numbers("E", no_effect)};
inline constexpr Arguments mesh{numbers("S", "mode"), numbers("Z", "mm"), numbers("VT", "mode")};
inline constexpr Arguments mesh_point{numbers("IJ", "point"), numbers("ZQ", "mm")};
inline constexpr Arguments probe_offset{numbers("XYZ", "mm")};
inline constexpr Arguments runout{numbers("S", "mode"), flags("R"), numbers("HD", no_effect)};
inline constexpr Arguments backlash{numbers("XYZ", "mm", 5), numbers("F", "of 1"),
                                    numbers("S", no_effect)};
inline constexpr Arguments change_lengths{numbers("LU", "mm"), numbers("T", "(tool)")};
inline constexpr Arguments filament_load{numbers("LZ", "mm"), numbers("T", "(tool in use)")};
inline constexpr Arguments filament_unload{numbers("UZ", "mm"), numbers("T", "(tool in use)")};
inline constexpr Arguments delta_geometry =
    may_be_delta ? Arguments{numbers("LRH", "mm"), numbers("XYZ", "°"), numbers("ABC", "mm"),
                             numbers("S", no_effect)}
                 : Arguments{};
inline constexpr Arguments end_stop_offsets =
    may_be_delta ? Arguments{numbers("XYZ", "mm")} : Arguments{};
inline constexpr Arguments name{text("name")};
inline constexpr Arguments message{text("text")};
inline constexpr Arguments marked_message{text("A1 E1 text")};

}  // namespace gcode_arguments

}  // namespace application
