// SPDX-License-Identifier: Apache-2.0
// M92 M201 M203 M204 M205 M207 M208 M209 as lines.
#include "application/setting_reports.hpp"

#include "units/event_bound.hpp"

namespace application {
namespace {

std::int32_t value_of(const motion::AxisLimits& axis, std::uint16_t code) {
  switch (code) {
    case 92:
      return axis.steps_per_meter.count();
    case 201:
      return axis.max_acceleration.count();
    case 203:
      return axis.max_speed.count();
    default:
      return axis.jerk.count();
  }
}

// Inches have one more decimal, since they are long.
void put(host_link::TextLine& line, char letter, std::int64_t nanometers, bool inches) {
  line.character(' ').character(letter);
  line.decimal(inches ? nanometers * 10 / 254 : nanometers, 6, inches ? 3 : 2);
}

}  // namespace

host_link::TextLine setting_report(std::uint16_t code, const motion::Limits& limits, bool inches) {
  constexpr std::int64_t nanometers_per_micrometer = 1000;
  units::EventBound<units::Event::long_digit, 0> numbers;
  host_link::TextLine line;
  const auto put_micrometers = [&](char letter, std::int32_t micrometers) {
    put(line, letter, micrometers * nanometers_per_micrometer, inches && code != 92);
  };
  line.text("echo: M").integer(code);
  if (code == 204) {
    put_micrometers('P', limits.print_acceleration.count());
    put_micrometers('R', limits.retract_acceleration.count());
    put_micrometers('T', limits.travel_acceleration.count());
    return line;
  }
  if (code >= 207) {
    const motion::Retraction& retraction = limits.retraction;
    if (automatic_retraction_in_image && code == 209) {
      line.text(" S").character(retraction.automatic ? '1' : '0');
      return line;
    }
    const auto put_values = [&](units::Nanometers length, units::MicrometersPerSecond speed) {
      put(line, 'S', length.count(), inches);
      put(line, 'F', speed.count() * motion::nanometers_per_minute, inches);
    };
    if (code == 208) {
      put_values(retraction.extra, retraction.recovery_speed);
      return line;
    }
    put_values(retraction.length, retraction.speed);
    put(line, 'Z', retraction.lift.count(), inches);
    return line;
  }
  if (code == 205) {
    put_micrometers('S', limits.min_print_speed.count());
    put_micrometers('T', limits.min_travel_speed.count());
    if (limits.junction_deviation != units::Nanometers()) {
      const std::int64_t deviation = limits.junction_deviation.count();
      line.text(" J").decimal(inches ? deviation * 10 / 254 : deviation, 6, 6);
    }
  }
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    put_micrometers(units::axis_letters[i], value_of(limits.axes[i], code));
  }
  return line;
}

host_link::TextLine backlash_report(const motion::BacklashSettings& backlash, bool inches) {
  units::EventBound<units::Event::long_digit, 0> numbers;
  host_link::TextLine line;
  line.text("echo: M425 F").decimal(backlash.correction, 6, 2);
  for (std::size_t i = 0; i < backlash.lengths.size(); ++i) {
    const std::int64_t length = backlash.lengths[i].count();
    line.character(' ').character(units::axis_letters[i]);
    line.decimal(inches ? length * 10 / 254 : length, 6, 3);
  }
  return line;
}

host_link::TextLine tool_change_report(const ToolChange& change, bool inches) {
  units::EventBound<units::Event::long_digit, 0> numbers;
  host_link::TextLine line;
  const auto put_speed = [&](char letter, units::MicrometersPerSecond speed) {
    put(line, letter, speed.count() * motion::nanometers_per_minute, inches);
  };
  line.text("echo: M217");
  put(line, 'S', change.swap.count(), inches);
  put(line, 'B', change.resume.count(), inches);
  put(line, 'E', change.prime.count(), inches);
  put_speed('P', change.prime_speed);
  put_speed('R', change.retract_speed);
  put_speed('U', change.unretract_speed);
  put(line, 'Z', change.lift.count(), inches);
  return line;
}

host_link::TextLine tool_offset_report(const ToolOffset& offset, bool inches) {
  units::EventBound<units::Event::long_digit, 0> numbers;
  host_link::TextLine line;
  line.text("echo: M218 T1");
  for (std::size_t i = 0; i < offset.size(); ++i) {
    const std::int64_t length = offset[i].count();
    line.character(' ').character(units::axis_letters[i]);
    line.decimal(inches ? length * 10 / 254 : length, 6, 3);
  }
  return line;
}

}  // namespace application
