// SPDX-License-Identifier: Apache-2.0
// The factors of speed and flow.
#include "application/factor_commands.hpp"

#include <algorithm>

namespace application {
namespace {

using std::literals::operator""sv;

constexpr std::int32_t unchanged = 100;  // percent

Stretch part_of(std::int32_t percent, std::int32_t whole) {
  if (percent >= whole) return Pace::one;
  const auto part = static_cast<std::uint32_t>(percent);
  const auto all = static_cast<std::uint32_t>(whole);
  return (part * Pace::one + all / 2) / all;
}

// S, which is within the range of its row.
std::int32_t factor_of(const ActiveCommand& command) {
  return static_cast<std::int32_t>(command.command.integer('S').value_or(unchanged));
}

Progress report(ActiveCommand& command, std::string_view name, std::int32_t percent) {
  host_link::TextLine line;
  return command.say(line.text(name).integer(percent).character('%'));
}

}  // namespace

// For the lines after it, as in Marlin. They are planned with all of it, so a person's stretch
// ends with the first of them.
Progress FactorCommands::set_speed(ActiveCommand& command) {
  const std::int32_t before = coordinates_.speed();
  std::int32_t speed = command.command.has('R') ? kept_speed_ : before;
  if (command.command.has('S')) speed = factor_of(command);
  if (command.command.has('B')) kept_speed_ = before;
  if (!command.command.has_any(gcode::Command::set_of("SR"))) return Progress::done;
  coordinates_.set_speed(speed, speed);
  motion_.set_stretch(motion_.stretch(), Pace::one);
  return Progress::done;
}

Progress FactorCommands::report_speed(ActiveCommand& command) {
  return report(command, "FR:", coordinates_.speed());
}

// What is planned already is stretched where it is too fast; it cannot be made faster within the
// limits of the axes. Lines to come are planned with what they were, or 100 % of what they request,
// and stretched as well, so that nothing changes where the first of them begins; or with all of it
// where that is more.
void FactorCommands::set_speed_at_once(std::int32_t percent) {
  const std::int32_t before = coordinates_.planned_speed();
  const std::int32_t least = motion_.stretches_time() ? std::min(before, unchanged) : 0;
  const std::int32_t planned = std::max(percent, least);
  coordinates_.set_speed(percent, planned);
  motion_.set_stretch(part_of(percent, before), part_of(percent, planned));
}

Progress FactorCommands::set_flow(ActiveCommand& command) {
  const auto tool = command.asked_tool(coordinates_.tools());
  if (!tool) return command.refuse_tool();
  if (units::most_tools > 1 && !command.command.has('S')) return report_flow(command);
  coordinates_.set_flow(*tool, factor_of(command));
  return Progress::done;
}

Progress FactorCommands::report_flow(ActiveCommand& command) {
  const std::size_t tool = command.asked_tool(coordinates_.tools()).value_or(0);
  const std::string_view name =
      units::most_tools == 1 || tool == 0 ? "echo:E0 Flow: "sv : "echo:E1 Flow: "sv;
  return report(command, name, coordinates_.flow(tool));
}

}  // namespace application
