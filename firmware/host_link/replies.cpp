// SPDX-License-Identifier: Apache-2.0
// Builds the reply texts.
#include "host_link/replies.hpp"

#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace host_link {

using namespace std::string_view_literals;
namespace {

constexpr unsigned millicelsius_digits = 3;
constexpr unsigned nanometer_digits = 6;  // of a millimetre
constexpr unsigned places = 2;

void add_heater(TextLine& line, std::string_view name, const HeaterState& heater) {
  line.text(name)
      .decimal(heater.temperature.count(), millicelsius_digits, places)
      .text(" /")
      .decimal(heater.target.count(), millicelsius_digits, places);
}

}  // namespace

void add_refused_command(TextLine& line, std::string_view command) {
  line.text(", not executed: \"").text(command).character('"');
}

TextLine temperature_report(const HeaterState& hotend, const HeaterState& bed) {
  units::EventBound<units::Event::long_digit, 0> numbers;
  TextLine line;
  add_heater(line, " T:", hotend);
  add_heater(line, " B:", bed);
  line.text(" @:").integer(hotend.power).text(" B@:").integer(bed.power);
  return line;
}

TextLine temperature_report(const HeaterState& active, const HeaterState& bed,
                            std::span<const HeaterState> hotends) {
  constexpr std::size_t most_hotends = 2;
  units::EventBound<units::Event::long_digit, 0> numbers;
  TextLine line;
  add_heater(line, " T:", active);
  add_heater(line, " B:", bed);
  units::LoopBound<most_hotends> temperatures;
  for (std::size_t i = 0; i < hotends.size(); ++i) {
    temperatures.next();
    add_heater(line.text(" T").integer(static_cast<std::int64_t>(i)), ":", hotends[i]);
  }
  line.text(" @:").integer(active.power).text(" B@:").integer(bed.power);
  units::LoopBound<most_hotends> powers;
  for (std::size_t i = 0; i < hotends.size(); ++i) {
    powers.next();
    line.text(" @").integer(static_cast<std::int64_t>(i)).character(':');
    line.integer(hotends[i].power);
  }
  return line;
}

void add_waiting_time(TextLine& report, std::optional<std::int32_t> seconds_left) {
  report.text(" W:");
  if (seconds_left) {
    report.integer(*seconds_left);
  } else {
    report.character('?');
  }
}

TextLine position_report(const units::PerAxis<units::Position>& position,
                         const units::PerAxis<units::Steps>& count, std::string_view motors) {
  units::EventBound<units::Event::long_digit, long_digits_of_position> numbers;
  TextLine line;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    line.character(units::axis_letters[axis]).character(':');
    line.decimal(position[axis].nearest().count(), nanometer_digits, places).character(' ');
  }
  line.text("Count");
  for (const units::Axis axis : {units::Axis::x, units::Axis::y, units::Axis::z}) {
    const std::size_t index = units::index_of(axis);
    line.character(' ').character(motors[index]).character(':');
    line.integer(count[index].count());
  }
  return line;
}

std::optional<TextLine> firmware_line(const FirmwareDescription& firmware, std::size_t index) {
  TextLine line;
  if (index == 0) {
    // OctoPrint takes the name up to the next key, Cura up to the last ';'.
    line.text("FIRMWARE_NAME:").text(firmware.name);
    if (!firmware.source_url.empty()) line.text(" SOURCE_CODE_URL:").text(firmware.source_url);
    line.text(" PROTOCOL_VERSION:1.0; MACHINE_TYPE:").text(firmware.machine);
    return line.text(" EXTRUDER_COUNT:").integer(firmware.extruders);
  }
  if (index > firmware.capabilities.size()) return std::nullopt;
  const Capability& capability = firmware.capabilities[index - 1];
  return line.text("Cap:").text(capability.name).text(capability.present ? ":1"sv : ":0"sv);
}

std::optional<TextLine> end_stop_line(std::span<const EndStopState> end_stops, std::size_t index) {
  TextLine line;
  if (index == 0) return line.text("Reporting endstop status");
  if (index > end_stops.size()) return std::nullopt;
  const EndStopState& end_stop = end_stops[index - 1];
  return line.text(end_stop.name).text(end_stop.triggered ? ": TRIGGERED"sv : ": open"sv);
}

TextLine unknown_command(std::string_view command) {
  TextLine line;
  line.text("echo:Unknown command: \"").text(command).character('"');
  return line;
}

TextLine not_executed(std::string_view reason, std::uint32_t position, std::string_view command) {
  TextLine line;
  line.text("echo:").text(reason).text(" at column ").integer(position + std::int64_t{1});
  add_refused_command(line, command);
  return line;
}

TextLine not_executed(std::string_view reason, std::string_view command) {
  TextLine line;
  line.text("echo:").text(reason);
  add_refused_command(line, command);
  return line;
}

}  // namespace host_link
