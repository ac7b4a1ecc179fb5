// SPDX-License-Identifier: Apache-2.0
// Recognises the commands that act at once.
#include "host_link/emergency.hpp"

#include "host_link/line_receiver.hpp"
#include "units/digits.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"
#include "units/text.hpp"

namespace host_link {
namespace {

using Kind = EmergencyCommand::Kind;

using units::is_digit;

constexpr std::uint8_t bit(Kind kind) {
  return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind));
}

constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }

constexpr std::uint32_t largest_code = 0xffff;  // the parser's

constexpr std::string_view action_prefix = "action:";

std::string_view without_front_blanks(std::string_view text) {
  units::LoopBound<max_line_length> blanks;
  while (!text.empty() && text.front() == ' ') {
    blanks.next();
    text.remove_prefix(1);
  }
  return text;
}

std::string_view without_blanks(std::string_view text) {
  text = without_front_blanks(text);
  units::LoopBound<max_line_length> blanks;
  while (!text.empty() && text.back() == ' ') {
    blanks.next();
    text.remove_suffix(1);
  }
  return text;
}

// "//action:pause", perhaps with blanks after the slashes.
std::optional<EmergencyCommand> action_in(std::string_view text) {
  text.remove_prefix(2);
  text = without_front_blanks(text);
  if (!units::starts_with(text, action_prefix)) return std::nullopt;
  text.remove_prefix(action_prefix.size());
  if (units::equal(text, "pause")) return EmergencyCommand{Kind::pause};
  if (units::equal(text, "resume")) return EmergencyCommand{Kind::resume};
  if (units::equal(text, "cancel")) return EmergencyCommand{Kind::cancel};
  return std::nullopt;
}

// S<n> anywhere after the command; a prompt has few buttons, so one or two digits count.
std::uint8_t button_in(std::string_view arguments) {
  units::EventBound<units::Event::character_read, max_line_length - shortest_command> read;
  if (!skip_behind_letter(arguments, 'S')) return 0;
  unsigned value = 0;
  units::LoopBound<max_line_length> digits;  // zeros may lead
  for (const char digit : arguments) {
    if (!is_digit(digit)) break;
    digits.next();
    value = value * 10 + static_cast<unsigned>(digit - '0');
    if (value > 99) return 0;
    units::happens<units::Event::character_read>(value);
  }
  return static_cast<std::uint8_t>(value);
}

}  // namespace

bool skip_behind_letter(std::string_view& text, char capital) {
  constexpr unsigned both_cases = ~0x20u;
  units::LoopBound<max_line_length> characters;
  while (!text.empty()) {
    characters.next();
    const auto letter = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    units::happens<units::Event::character_read>(text.size());
    if ((letter & both_cases) == static_cast<unsigned char>(capital)) return true;
  }
  return false;
}

std::uint32_t take_code_behind_m(std::string_view& text) {
  units::EventBound<units::Event::character_read, max_line_length - 1> read;
  std::size_t end = 1;
  units::LoopBound<max_line_length> blanks;
  while (end < text.size() && is_blank(text[end])) {
    blanks.next();
    ++end;
    units::happens<units::Event::character_read>(end);
  }
  std::uint32_t code = 0;
  units::LoopBound<max_line_length, 1> digits;
  for (; end < text.size() && is_digit(text[end]); ++end) {
    digits.next();
    code = code * 10 + static_cast<std::uint32_t>(text[end] - '0');
    if (code > largest_code) return 0;
    units::happens<units::Event::character_read>(code);
  }
  if (end < text.size() && text[end] == '.') return 0;
  text.remove_prefix(end);
  return code;
}

std::optional<EmergencyCommand> emergency_in(const ReceivedLine& line) {
  if (units::starts_with(line.text, "//")) {
    return action_in(line.text);
  }
  switch (line.m_code) {
    case 112:
      return EmergencyCommand{Kind::kill};
    case 108:
      return EmergencyCommand{Kind::cancel_wait};
    case 410:
      return EmergencyCommand{Kind::quick_stop};
    case 602:
      return EmergencyCommand{Kind::prompt_response};
    case 876:
      return EmergencyCommand{Kind::prompt_response, button_in(line.arguments)};
    default:
      return std::nullopt;
  }
}

std::optional<EmergencyCommand> speed_in(const ReceivedLine& line) {
  constexpr unsigned speed_code = 220;
  if (line.m_code != speed_code) return std::nullopt;
  std::string_view text =
      without_blanks(line.arguments.substr(0, units::find(line.arguments, ';')));
  if (text.size() < 2 || (text[0] != 'S' && text[0] != 's')) return std::nullopt;
  text.remove_prefix(1);
  unsigned percent = 0;
  units::LoopBound<max_line_length> digits;
  for (const char digit : text) {
    digits.next();
    if (!is_digit(digit)) return std::nullopt;
    percent = percent * 10 + static_cast<unsigned>(digit - '0');
    if (percent > largest_speed_factor) return std::nullopt;
  }
  if (percent == 0) return std::nullopt;
  return EmergencyCommand{Kind::speed, static_cast<std::uint16_t>(percent)};
}

void EmergencyQueue::put(EmergencyCommand command) {
  // Of these two the later one counts.
  unsigned replaced = 0;
  if (command.kind == Kind::pause) replaced = bit(Kind::resume);
  if (command.kind == Kind::resume) replaced = bit(Kind::pause);
  pending_ = static_cast<std::uint8_t>((pending_ & ~replaced) | bit(command.kind));
  if (command.kind == Kind::prompt_response) prompt_value_ = command.value;
  if (command.kind == Kind::speed) speed_ = command.value;
}

std::optional<EmergencyCommand> EmergencyQueue::next() {
  if (pending_ == 0) return std::nullopt;
  units::LoopBound<EmergencyCommand::kinds> asked;
  for (const Kind kind : {Kind::kill, Kind::cancel, Kind::quick_stop, Kind::cancel_wait,
                          Kind::prompt_response, Kind::speed, Kind::pause, Kind::resume}) {
    asked.next();
    if ((pending_ & bit(kind)) == 0) continue;
    pending_ = static_cast<std::uint8_t>(pending_ & ~bit(kind));
    const std::uint16_t value = kind == Kind::prompt_response ? prompt_value_
                                : kind == Kind::speed         ? speed_
                                                              : std::uint16_t{0};
    return EmergencyCommand{kind, value};
  }
  return std::nullopt;
}

}  // namespace host_link
