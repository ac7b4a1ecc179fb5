// SPDX-License-Identifier: Apache-2.0
// The dialogue player.
#include "tests/host_link/dialogue.hpp"

#include <algorithm>
#include <fstream>
#include <span>

namespace host_link::test {
namespace {

std::string unescape(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      bytes += text[i];
      continue;
    }
    switch (text[++i]) {
      case 'n':
        bytes += '\n';
        break;
      case 'r':
        bytes += '\r';
        break;
      case 't':
        bytes += '\t';
        break;
      case 'x':
        bytes += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
        i += 2;
        break;
      default:
        bytes += text[i];
    }
  }
  return bytes;
}

std::string name_of(const EmergencyCommand& command) {
  switch (command.kind) {
    case EmergencyCommand::Kind::kill:
      return "kill";
    case EmergencyCommand::Kind::cancel_wait:
      return "cancel";
    case EmergencyCommand::Kind::quick_stop:
      return "stop";
    case EmergencyCommand::Kind::prompt_response:
      return "prompt " + std::to_string(command.value);
    case EmergencyCommand::Kind::pause:
      return "action pause";
    case EmergencyCommand::Kind::resume:
      return "action resume";
    case EmergencyCommand::Kind::cancel:
      return "action cancel";
    case EmergencyCommand::Kind::speed:
      return "speed " + std::to_string(command.value);
  }
  return "?";
}

std::string differs(const std::string& expected, const std::string& happened) {
  return "expected \"" + expected + "\", happened \"" + happened + "\"";
}

}  // namespace

std::optional<std::string> Dialogue::play(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return "cannot read " + file.string();
  for (const DialogueStep& next : dialogue_steps(stream)) {
    const std::string wrong = step(next);
    if (!wrong.empty()) {
      return file.filename().string() + ":" + std::to_string(next.line) + ": " + next.text() +
             "\n  " + wrong;
    }
  }
  const std::string rest = leftovers();
  if (!rest.empty()) return file.filename().string() + ": at the end: " + rest;
  return std::nullopt;
}

std::string Dialogue::step(const DialogueStep& next) {
  const std::string &verb = next.verb, &argument = next.argument;
  if (verb == "<-") return expect_line(argument);
  if (verb == "<*") return expect_part(argument);
  if (verb == "=>") return expect_taken(argument);
  if (verb == "??") return expect_query(argument);
  if (verb == "!!") return expect_emergency(argument);
  if (verb == "set") return set(argument);
  if (verb == "repeat") return repeat(next);
  if (verb == "->") {
    send(with_checksum(argument) + "\n");
  } else if (verb == "~>") {
    send(unescape(argument));
  } else if (verb == "idle") {
    pass(std::stol(argument), Activity::idle);
  } else if (verb == "busy") {
    pass(std::stol(argument), Activity::processing);
  } else if (verb == "paused") {
    pass(std::stol(argument), Activity::paused_for_user);
  } else if (verb == "done") {
    if (!link_.finished(argument.empty() ? "" : " " + argument)) return "no room for the ok";
    link_.update(now_, activity_);
  } else if (next.text() == "again" || next.text() == "not again") {
    if (link_.ask_again() != (verb == "again")) return "the other one";
    link_.update(now_, activity_);
  } else if (verb == "answer") {
    if (!link_.query_answered(argument.empty() ? "" : " " + argument)) return "no room for the ok";
  } else if (verb == "say") {
    if (!link_.say(unescape(argument))) return "no room for the line";
  } else {
    return "unknown step";
  }
  return "";
}

std::string Dialogue::repeat(const DialogueStep& many) {
  const DialogueStep one = dialogue_step(many.argument, many.line);
  const int times = std::stoi(one.verb);
  for (int i = 0; i < times; ++i) {
    std::string text = one.argument;
    for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#', at)) {
      text.replace(at, 1, std::to_string(i));
    }
    const std::string wrong = step(dialogue_step(text, many.line));
    if (!wrong.empty()) return "round " + std::to_string(i) + ": " + wrong;
  }
  return "";
}

std::string Dialogue::expect_line(const std::string& expected) {
  collect();
  if (lines_.empty()) return expected == "nothing" ? "" : differs(expected, "nothing");
  const std::string line = lines_.front();
  lines_.pop_front();
  return line == expected ? "" : differs(expected, line);
}

std::string Dialogue::expect_part(const std::string& expected) {
  collect();
  if (lines_.empty()) return differs(expected, "nothing");
  const std::string line = lines_.front();
  lines_.pop_front();
  return line.find(expected) != std::string::npos ? "" : differs("..." + expected + "...", line);
}

std::string Dialogue::expect_taken(const std::string& expected) {
  const std::optional<AcceptedLine> line = link_.next_line();
  std::string taken = "nothing";
  if (line) {
    taken = (line->number ? std::to_string(written(*line->number)) : "-") + " " +
            std::string(line->text);
    if (line->emergency) taken += " (acted on)";
  }
  return taken == expected ? "" : differs(expected, taken);
}

std::string Dialogue::expect_query(const std::string& expected) {
  const auto code = link_.query();
  const std::string happened = code ? std::to_string(*code) : "nothing";
  return happened == expected ? "" : differs(expected, happened);
}

std::string Dialogue::expect_emergency(const std::string& expected) {
  const std::optional<EmergencyCommand> command = link_.emergency();
  const std::string happened = command ? name_of(*command) : "nothing";
  return happened == expected ? "" : differs(expected, happened);
}

std::string Dialogue::set(const std::string& argument) {
  constexpr std::string_view interval = "busy_interval ";
  if (argument == "advanced_ok") {
    link_.set_advanced_ok(true);
    link_.set_planner_space(15);
  } else if (argument.starts_with(interval)) {
    link_.set_busy_interval(units::Milliseconds(std::stol(argument.substr(interval.size()))));
  } else {
    return "unknown setting";
  }
  return "";
}

// As the application does: a line at a time, and what is owed is sent with the update behind it.
void Dialogue::send(const std::string& bytes) {
  for (std::span rest(bytes); !rest.empty();) {
    const auto end = std::ranges::find_if(rest, [](char c) { return c == '\n' || c == '\r'; });
    const auto length = static_cast<std::size_t>(end - rest.begin());
    const std::size_t count = std::min(length + 1, rest.size());
    link_.receive(rest.first(count), now_);
    link_.update(now_, activity_);
    rest = rest.subspan(count);
  }
}

void Dialogue::pass(long milliseconds, Activity activity) {
  constexpr long step_length = 10;
  activity_ = activity;
  for (long passed = 0; passed < milliseconds; passed += step_length) {
    now_ += units::Milliseconds(step_length);
    link_.update(now_, activity);
    collect();
  }
}

void Dialogue::collect() {
  for (std::span<const char> bytes = link_.to_send(); !bytes.empty(); bytes = link_.to_send()) {
    for (const char c : bytes) {
      if (c != '\n') {
        partial_ += c;
        continue;
      }
      lines_.push_back(partial_);
      partial_.clear();
    }
    link_.sent(bytes.size());
  }
}

std::string Dialogue::leftovers() {
  collect();
  if (!lines_.empty()) return "unexpected reply \"" + lines_.front() + "\"";
  if (!partial_.empty()) return "half a reply \"" + partial_ + "\"";
  const std::string query = expect_query("nothing");
  if (!query.empty()) return query;
  const std::string emergency = expect_emergency("nothing");
  if (!emergency.empty()) return emergency;
  return expect_taken("nothing");
}

}  // namespace host_link::test
