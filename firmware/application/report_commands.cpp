// SPDX-License-Identifier: Apache-2.0
// Temperatures, positions, end stops, and the firmware's identity.
#include "application/report_commands.hpp"

#include <array>

#include "application/capabilities.hpp"
#include "host_link/replies.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

using std::literals::operator""sv;

constexpr std::array<std::string_view, 3> end_stop_names{"x_min", "y_min", "z_min"};

Progress set(units::Milliseconds& interval, const ActiveCommand& command) {
  interval = command.seconds().value_or(interval);
  return Progress::done;
}

}  // namespace

bool ReportCommands::first_temperatures_awaited(units::Milliseconds now) const {
  constexpr units::Milliseconds longest_wait{1000};
  if (now >= longest_wait) return false;
  return !heat_.all_measured();
}

Progress ReportCommands::say_temperature(Reply& reply, units::Milliseconds now) const {
  if (first_temperatures_awaited(now)) return Progress::again;
  reply.behind_ok = temperature_line();
  return Progress::done;
}

host_link::TextLine ReportCommands::temperature_line() const { return heat_.report(); }

host_link::TextLine ReportCommands::position_line() const {
  return host_link::position_report(coordinates_.logical(), motion_.steps(),
                                    motion_.kinematics().motor_letters());
}

Progress ReportCommands::say_firmware(Reply& reply) const {
  auto present = capabilities();
  present.back().present = machine_.advanced_ok;
  const host_link::FirmwareDescription firmware{
      .name = "StepFabric",
      .source_url = {},
      .machine = machine_.name,
      .extruders = static_cast<std::uint8_t>(machine_.tools()),
      .capabilities = present};
  // The firmware's name, then the capabilities, then nothing: one in each pass.
  if (const auto line = host_link::firmware_line(firmware, reply.lines_said)) {
    if (reply.say(*line) == Progress::done) ++reply.lines_said;
    return Progress::again;
  }
  return motion_.levels() ? say_levelling(reply) : Progress::done;
}

// Capabilities too, of a machine with a probe.
Progress ReportCommands::say_levelling(Reply& reply) const {
  constexpr std::array<std::string_view, 3> list{"Cap:AUTOLEVEL:1", "Cap:LEVELING_DATA:1",
                                                 "Cap:Z_PROBE:1"};
  constexpr std::size_t before = capability_count + 1;
  units::LoopBound<list.size()> lines;
  for (; reply.lines_said < before + list.size(); ++reply.lines_said) {
    lines.next();
    if (reply.say(list[reply.lines_said - before]) == Progress::again) return Progress::again;
  }
  return Progress::done;
}

Progress ReportCommands::report_end_stops(ActiveCommand& command) {
  std::array<host_link::EndStopState, end_stop_names.size()> states{};
  const std::uint32_t triggered = motion_.end_stops();
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& homing = motion_.limits().axes[i].homing;
    states[i] = {end_stop_names[i], homing && (triggered >> homing->end_stop & 1u) != 0};
  }
  units::LoopBound<end_stop_names.size() + 1> lines;
  while (const auto line = host_link::end_stop_line(states, command.lines_said)) {
    lines.next();
    if (command.say(*line) == Progress::again) return Progress::again;
    ++command.lines_said;
  }
  const std::size_t first = end_stop_names.size() + 1;
  if (motion_.levels() && command.lines_said == first) {
    const auto line = motion_.probe_triggered() ? "z_probe: TRIGGERED"sv : "z_probe: open"sv;
    if (command.say(line) == Progress::again) return Progress::again;
    ++command.lines_said;
  }
  if (!filament_in_image || machine_.filament_sensor == nullptr) return Progress::done;
  const bool is_out = (triggered >> machine_.filament_sensor->input & 1u) != 0;
  return command.say(is_out ? "filament: TRIGGERED"sv : "filament: open"sv);
}

// "echo:Task overruns 1:0 2:0 3:1 ...": by their priority.
Progress ReportCommands::report_tasks(ActiveCommand& command) {
  host_link::TextLine line;
  line.text("echo:Task overruns");
  units::LoopBound<units::task_count> tasks;
  for (std::uint32_t task = 0; task < units::task_count; ++task) {
    tasks.next();
    line.character(' ').integer(task + 1).character(':').integer(counters_.tasks[task].overruns);
  }
  return command.say(line);
}

Progress ReportCommands::set_position_interval(ActiveCommand& command) {
  return set(position_interval_, command);
}

Progress ReportCommands::set_temperature_interval(ActiveCommand& command) {
  return set(temperature_interval_, command);
}

Progress ReportCommands::answer_ahead(std::uint8_t code, Reply& reply, units::Milliseconds now) {
  switch (code) {
    case 105:
      return say_temperature(reply, now);
    case 114:
      return say_position(reply);
    default:
      return say_firmware(reply);
  }
}

}  // namespace application
