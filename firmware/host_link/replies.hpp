// SPDX-License-Identifier: Apache-2.0
// The texts that hosts parse, made from plain values in the form of Marlin.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "host_link/text_line.hpp"
#include "units/axes.hpp"
#include "units/position.hpp"
#include "units/quantity.hpp"

namespace host_link {

// Sent once after a reset: hosts restart their numbering when they see it.
inline constexpr std::string_view greeting = "start";

struct HeaterState {
  units::Millicelsius temperature;
  units::Millicelsius target;
  std::uint8_t power{};  // 0 .. 127, as Marlin reports it
};

// " T:205.10 /205.00 B:60.00 /60.00 @:64 B@:0": after the "ok" of M105, or as a line of its own.
TextLine temperature_report(const HeaterState& hotend, const HeaterState& bed);

// Of several hotends, of which `active` is that of the tool that is in use: behind the same for it
// and the bed each has its temperature and its power, " T0:205.10 /205.00 ... @0:64".
TextLine temperature_report(const HeaterState& active, const HeaterState& bed,
                            std::span<const HeaterState> hotends);

// Behind the report in the line of M109 and M190 each second: " W:3", the seconds that the
// temperature must still hold, or " W:?" while it is not yet reached.
void add_waiting_time(TextLine& report, std::optional<std::int32_t> seconds_left);

// Numbers of a position report that need more than 32 bits: G92 sets any coordinate.
inline constexpr std::uint32_t long_digits_of_position = units::axis_count;

// M114: "X:0.00 Y:0.00 Z:0.00 E:0.00 Count X:0 Y:0 Z:0", what was requested and the motors' steps.
TextLine position_report(const units::PerAxis<units::Position>& position,
                         const units::PerAxis<units::Steps>& count,
                         std::string_view motors = "XYZ");

struct Capability {
  std::string_view name;  // "AUTOREPORT_TEMP"
  bool present;
};

struct FirmwareDescription {
  std::string_view name;  // with version; no words that switch a host's quirks on (README)
  std::string_view source_url;  // left out if empty
  std::string_view machine;
  std::uint8_t extruders;
  std::span<const Capability> capabilities;
};

// M115, line by line: index 0 is the firmware, then one "Cap:NAME:1" each; empty after the last.
std::optional<TextLine> firmware_line(const FirmwareDescription& firmware, std::size_t index);

// M119, line by line: a heading, then "x_min: open" or "x_min: TRIGGERED" each; empty
// after the last.
struct EndStopState {
  std::string_view name;  // "x_min"
  bool triggered;
};
std::optional<TextLine> end_stop_line(std::span<const EndStopState> end_stops, std::size_t index);

// echo:Unknown command: "G999"
TextLine unknown_command(std::string_view command);
// echo:Malformed number at column 4, not executed: "G1 X1.2.3"
TextLine not_executed(std::string_view reason, std::uint32_t position, std::string_view command);
// echo:Move beyond the end of X, not executed: "G1 X900"
TextLine not_executed(std::string_view reason, std::string_view command);
// The second half of it, behind "echo:" and the reason.
void add_refused_command(TextLine& line, std::string_view command);
// Error:Printer halted. kill() called! (the last words after M112: hosts disconnect on it)
inline constexpr std::string_view halted = "Error:Printer halted. kill() called!";

}  // namespace host_link
