// SPDX-License-Identifier: Apache-2.0
// Recognises the commands that act at once.
#include "host_link/emergency.hpp"

namespace host_link {
namespace {

using Kind = EmergencyCommand::Kind;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::uint8_t bit(Kind kind) {
  return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind));
}

constexpr std::string_view action_prefix = "action:";

// "//action:pause", perhaps with blanks behind the slashes.
std::optional<EmergencyCommand> action_in(std::string_view text) {
  text.remove_prefix(2);
  while (text.starts_with(' ')) text.remove_prefix(1);
  if (!text.starts_with(action_prefix)) return std::nullopt;
  text.remove_prefix(action_prefix.size());
  if (text == "pause") return EmergencyCommand{Kind::pause};
  if (text == "resume") return EmergencyCommand{Kind::resume};
  if (text == "cancel") return EmergencyCommand{Kind::cancel};
  return std::nullopt;
}

// S<n> anywhere behind the command; a prompt has few buttons, so one or two digits count.
std::uint8_t button_in(std::string_view parameters) {
  const std::size_t letter = parameters.find_first_of("Ss");
  if (letter == std::string_view::npos) return 0;
  unsigned value = 0;
  for (std::size_t i = letter + 1; i < parameters.size() && is_digit(parameters[i]); ++i) {
    value = value * 10 + static_cast<unsigned>(parameters[i] - '0');
    if (value > 99) return 0;
  }
  return static_cast<std::uint8_t>(value);
}

}  // namespace

std::optional<EmergencyCommand> emergency_in(std::string_view text) {
  if (text.starts_with("//")) return action_in(text);
  if (text.size() < 4 || (text[0] != 'M' && text[0] != 'm')) return std::nullopt;
  std::size_t end = 1;
  unsigned code = 0;
  while (end < text.size() && is_digit(text[end]) && end < 6) {
    code = code * 10 + static_cast<unsigned>(text[end++] - '0');
  }
  if (end < text.size() && (is_digit(text[end]) || text[end] == '.')) return std::nullopt;
  text.remove_prefix(end);
  switch (code) {
    case 112:
      return EmergencyCommand{Kind::kill};
    case 108:
      return EmergencyCommand{Kind::cancel_wait};
    case 410:
      return EmergencyCommand{Kind::quick_stop};
    case 876:
      return EmergencyCommand{Kind::prompt_response, button_in(text)};
    default:
      return std::nullopt;
  }
}

void EmergencyQueue::put(EmergencyCommand command) {
  // Of these two the later one counts.
  unsigned replaced = 0;
  if (command.kind == Kind::pause) replaced = bit(Kind::resume);
  if (command.kind == Kind::resume) replaced = bit(Kind::pause);
  pending_ = static_cast<std::uint8_t>((pending_ & ~replaced) | bit(command.kind));
  if (command.kind == Kind::prompt_response) prompt_value_ = command.value;
}

std::optional<EmergencyCommand> EmergencyQueue::next() {
  for (const Kind kind : {Kind::kill, Kind::cancel, Kind::quick_stop, Kind::cancel_wait,
                          Kind::prompt_response, Kind::pause, Kind::resume}) {
    if ((pending_ & bit(kind)) == 0) continue;
    pending_ = static_cast<std::uint8_t>(pending_ & ~bit(kind));
    return EmergencyCommand{kind, kind == Kind::prompt_response ? prompt_value_ : std::uint8_t{0}};
  }
  return std::nullopt;
}

}  // namespace host_link
