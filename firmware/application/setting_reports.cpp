// SPDX-License-Identifier: Apache-2.0
// M92 M201 M203 M204 M205 as lines.
#include "application/setting_reports.hpp"

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

void put(host_link::TextLine& line, char letter, std::int32_t thousandths) {
  line.character(' ').character(letter).decimal(thousandths, 3, 2);
}

}  // namespace

host_link::TextLine setting_report(std::uint16_t code, const motion::Limits& limits) {
  host_link::TextLine line;
  line.text("echo: M").integer(code);
  if (code == 204) {
    put(line, 'P', limits.print_acceleration.count());
    put(line, 'R', limits.retract_acceleration.count());
    put(line, 'T', limits.travel_acceleration.count());
    return line;
  }
  if (code == 205) {
    put(line, 'S', limits.min_print_speed.count());
    put(line, 'T', limits.min_travel_speed.count());
    if (limits.junction_deviation != units::Nanometers()) {
      line.text(" J").decimal(static_cast<std::int32_t>(limits.junction_deviation.count()), 6, 6);
    }
  }
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    put(line, units::axis_letters[i], value_of(limits.axes[i], code));
  }
  return line;
}

}  // namespace application
