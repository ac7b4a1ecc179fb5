// SPDX-License-Identifier: Apache-2.0
// M92 M201 M203 M204 M205 as lines, all of them by M503.
#include "application/setting_reports.hpp"

#include "application/command_executor.hpp"

namespace application {
namespace {

// Of steps per metre, um/s, um/s^2: all in thousandths of what is written.
constexpr unsigned digits = 3;
constexpr unsigned places = 2;

void put(host_link::TextLine& line, char letter, auto value) {
  line.character(' ').character(letter).decimal(value.count(), digits, places);
}

template <class Quantity>
void put_axes(host_link::TextLine& line, const motion::Limits& limits,
              Quantity motion::AxisLimits::* value) {
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    put(line, units::axis_letters[i], limits.axes[i].*value);
  }
}

}  // namespace

host_link::TextLine setting_report(std::uint16_t code, const motion::Limits& limits) {
  host_link::TextLine line;
  line.text("echo: M").integer(code);
  switch (code) {
    case 92:
      put_axes(line, limits, &motion::AxisLimits::steps_per_meter);
      break;
    case 201:
      put_axes(line, limits, &motion::AxisLimits::max_acceleration);
      break;
    case 203:
      put_axes(line, limits, &motion::AxisLimits::max_speed);
      break;
    case 204:
      put(line, 'P', limits.print_acceleration);
      put(line, 'R', limits.retract_acceleration);
      put(line, 'T', limits.travel_acceleration);
      break;
    default:
      put(line, 'S', limits.min_print_speed);
      put(line, 'T', limits.min_travel_speed);
      put_axes(line, limits, &motion::AxisLimits::jerk);
  }
  return line;
}

// M92, M201, M203, M204 or M205 without values.
CommandExecutor::Progress CommandExecutor::report_setting() {
  return say(setting_report(command_.code, motion_.limits()));
}

CommandExecutor::Progress CommandExecutor::list_settings() {
  for (; list_index_ < reported_settings.size(); ++list_index_) {
    const auto line = setting_report(reported_settings[list_index_], motion_.limits());
    if (say(line) == Progress::again) return Progress::again;
  }
  return Progress::done;
}

}  // namespace application
