// SPDX-License-Identifier: Apache-2.0
// Numbers of the current command, and its refusals.
#include "application/active_command.hpp"

#include "host_link/replies.hpp"

namespace application {
namespace {

constexpr std::int64_t millionths_per_millisecond = 1'000'000 / 1000;  // of a second's parameter

}  // namespace

std::optional<std::int64_t> ActiveCommand::integer(char letter) const {
  const auto number = command.integer(letter);
  if (!number) return std::nullopt;
  return clamped(limits, letter, *number, 1);
}

units::Milliseconds ActiveCommand::asked_time() const {
  if (const auto seconds = value('S')) {
    return units::Milliseconds(*seconds / millionths_per_millisecond);
  }
  return units::Milliseconds(integer('P').value_or(0));
}

std::optional<units::Milliseconds> ActiveCommand::seconds() const {
  const auto whole = integer('S');
  if (!whole) return std::nullopt;
  return units::Milliseconds(*whole * 1000);
}

std::optional<std::int64_t> ActiveCommand::value(char letter) const {
  const auto number = command.value(letter);
  if (!number) return std::nullopt;
  return clamped(limits, letter, *number, gcode::millionths_per_unit);
}

units::AxisSet ActiveCommand::named_axes() const {
  units::AxisSet axes;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    if (command.has(units::axis_letters[i])) axes.insert(static_cast<units::Axis>(i));
  }
  return axes;
}

Progress ActiveCommand::refuse(std::string_view reason) {
  return refuse(host_link::not_executed(reason, text));
}

Progress ActiveCommand::refuse(const ArgumentLimit& violated) {
  auto line = describe(command, violated);
  return violated.check == Check::tool ? refuse(line) : refuse_for(line);
}

Progress ActiveCommand::refuse_for(host_link::TextLine& line) {
  host_link::add_refused_command(line, text);
  return refuse(line);
}

Progress ActiveCommand::report_not_fitted() {
  refused = command.letter == 'G';
  host_link::TextLine line;
  line.text("echo:").character(command.letter).integer(command.code);
  return say(line.text(" not fitted"));
}

std::optional<std::size_t> ActiveCommand::asked_tool(const Tools& tools) const {
  if (units::most_tools == 1 || tools.count() == 1) return 0;
  const std::int64_t tool =
      command.integer('T').value_or(static_cast<std::int64_t>(tools.in_use()));
  if (tool < 0 || tool >= static_cast<std::int64_t>(tools.count())) return std::nullopt;
  return static_cast<std::size_t>(tool);
}

Progress ActiveCommand::refuse_tool() {
  constexpr ArgumentLimit tool{.letter = 'T', .check = Check::tool};
  return refuse(tool);
}

Progress ActiveCommand::refuse_unknown() { return refuse(host_link::unknown_command(text)); }

}  // namespace application
