// SPDX-License-Identifier: Apache-2.0
// The commands that report: M105 M114 M115 M118 M119, and T, which has nothing to choose from.
#include <array>

#include "application/command_executor.hpp"
#include "host_link/replies.hpp"

namespace application {
namespace {

// What is true, not what would please: hosts act on it.
constexpr std::array<host_link::Capability, 10> capabilities{
    {{"EEPROM", false},
     {"AUTOREPORT_TEMP", true},
     {"AUTOREPORT_POS", true},
     {"PROGRESS", false},
     {"EMERGENCY_PARSER", true},
     {"SDCARD", false},
     {"ARCS", false},
     {"HOST_ACTION_COMMANDS", true},
     {"PROMPT_SUPPORT", true},
     {"ADVANCED_OK", false}}};  // the last one as the machine description says

constexpr std::array<std::string_view, 3> end_stop_names{"x_min", "y_min", "z_min"};

// By what a host knows answers; in a message it would be one too many, or send the print back.
bool reads_as_answer(std::string_view text) {
  const auto begins_with = [text](std::string_view word) {
    for (std::size_t i = 0; i < word.size(); ++i) {
      if (i == text.size() || (text[i] | 0x20) != word[i]) return false;
    }
    return true;
  };
  return begins_with("ok") || begins_with("resend") || begins_with("rs ") || begins_with("start");
}

}  // namespace

// The first conversions take some 100 ms; before them a temperature would be 0.
CommandExecutor::Progress CommandExecutor::report_temperature(Now now) {
  constexpr units::Milliseconds longest_wait{1000};
  const bool known =
      heat_.loop(Heater::hotend).temperature() && heat_.loop(Heater::bed).temperature();
  if (!known && now.milliseconds < longest_wait) return Progress::again;
  ok_report_ = host_link::temperature_report(heat_.state(Heater::hotend), heat_.state(Heater::bed));
  return Progress::done;
}

// Ahead of the line in hand, which has perhaps to wait long.
void CommandExecutor::answer_queries() {
  while (const auto code = link_.query()) {
    host_link::TextLine report;
    switch (*code) {
      case 105:
        report =
            host_link::temperature_report(heat_.state(Heater::hotend), heat_.state(Heater::bed));
        break;
      case 114:
        if (report_position() == Progress::again) return;
        break;
      default:
        if (list_firmware(query_index_) == Progress::again) return;
    }
    if (!link_.query_answered(report.view())) return;
    query_index_ = 0;
  }
}

CommandExecutor::Progress CommandExecutor::report_position() { return say(position_line()); }

host_link::TextLine CommandExecutor::position_line() {
  return host_link::position_report(coordinates_.logical(), motion_.steps());
}

CommandExecutor::Progress CommandExecutor::list_firmware(std::size_t& index) {
  auto present = capabilities;
  present.back().present = machine_.advanced_ok;
  const host_link::FirmwareDescription firmware{.name = "StepFabric",
                                                .source_url = {},
                                                .machine = machine_.name,
                                                .extruders = 1,
                                                .capabilities = present};
  while (const auto line = host_link::firmware_line(firmware, index)) {
    if (say(*line) == Progress::again) return Progress::again;
    ++index;
  }
  return Progress::done;
}

CommandExecutor::Progress CommandExecutor::list_end_stops() {
  std::array<host_link::EndStopState, end_stop_names.size()> states{};
  const std::uint32_t triggered = motion_.end_stops();
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& homing = motion_.limits().axes[i].homing;
    states[i] = {end_stop_names[i], homing && (triggered >> homing->end_stop & 1u) != 0};
  }
  while (const auto line = host_link::end_stop_line(states, list_index_)) {
    if (say(*line) == Progress::again) return Progress::again;
    ++list_index_;
  }
  return Progress::done;
}

// M118 [A1] [E1] text: A1 makes it an action command, E1 an echo.
CommandExecutor::Progress CommandExecutor::say_text() {
  std::string_view text = command_.text;
  bool action = false;
  bool echo = false;
  const auto takes = [&text](std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    while (text.starts_with(' ')) text.remove_prefix(1);
    return true;
  };
  for (bool more = true; more;) {
    if (takes("A1")) {
      action = true;
    } else if (takes("E1")) {
      echo = true;
    } else {
      more = takes("P0");
    }
  }
  host_link::TextLine line;
  if (echo || (!action && reads_as_answer(text))) line.text("echo:");
  if (action) line.text("//");
  return say(line.text(text));
}

bool CommandExecutor::wants_other_tool() const { return command_.integer('T').value_or(0) != 0; }

CommandExecutor::Progress CommandExecutor::refuse_tool() {
  host_link::TextLine line;
  line.text("echo:M").integer(command_.code).text(" Invalid extruder ");
  return refuse(line.integer(*command_.integer('T')));
}

CommandExecutor::Progress CommandExecutor::select_tool() {
  if (command_.code == 0) return Progress::done;
  host_link::TextLine line;
  return refuse(line.text("echo:T").integer(command_.code).text(" Invalid extruder"));
}

}  // namespace application
