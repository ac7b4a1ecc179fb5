// SPDX-License-Identifier: Apache-2.0
// Questions to the user, requests to the host, and the start of the boot loader.
#include "application/host_commands.hpp"

#include <array>

#include "platform/boot_loader.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"
#include "units/text.hpp"

namespace application {
namespace {

// Words by which a host recognises acknowledgements; in a message they would count as one too many,
// or cause resends.
bool reads_as_answer(std::string_view text) {
  const auto begins_with = [text](std::string_view word) {
    constexpr std::size_t longest_word = 6;
    units::LoopBound<longest_word> characters;
    for (std::size_t i = 0; i < word.size(); ++i) {
      characters.next();
      if (i == text.size() || (text[i] | 0x20) != word[i]) return false;
    }
    return true;
  };
  return begins_with("ok") || begins_with("resend") || begins_with("rs ") || begins_with("start");
}

std::string_view text_of(Question question) {
  switch (question) {
    case Question::go_on:
      return "Waiting for the user";
    case Question::change_filament:
      return "Change the filament";
    case Question::end_pause:
      return "Paused";
  }
  return "";
}

// "echo:M113 S2"
Progress report_seconds(ActiveCommand& command, units::Milliseconds interval) {
  host_link::TextLine line;
  line.text("echo:M").integer(command.command.code).text(" S");
  return command.say(line.integer(interval.count() / 1000));
}

}  // namespace

// Until M108, M602, M876 or, if M0 or M1 has P or S, its end. Hosts that know prompts show a
// button; M600 and M601 also inform hosts that print a file that it is paused, and that it goes on.
Progress HostCommands::ask_user(ActiveCommand& command, Question question) {
  const bool pauses = question != Question::go_on;
  std::size_t& said = command.lines_said;
  const units::Milliseconds now = command.now.milliseconds;
  if (command.phase == ActiveCommand::Phase::begin) {
    static constexpr std::array<std::string_view, 4> prompt{
        "paused", "prompt_begin ", "prompt_button Continue", "prompt_show"};
    if (!pauses && said == 0) said = 1;
    units::LoopBound<prompt.size()> lines;
    for (; said < prompt.size(); ++said) {
      lines.next();
      host_link::TextLine line;
      line.text("//action:").text(prompt[said]);
      if (said == 1) line.text(text_of(question));
      if (command.say(line) == Progress::again) return Progress::again;
    }
    const auto time = pauses ? units::Milliseconds{} : command.asked_time();
    answer_due_ = time.count() > 0 ? now + time : units::Milliseconds{};
    said = 0;
    command.phase = ActiveCommand::Phase::asking;
  }
  const bool over = answer_due_.count() != 0 && now >= answer_due_;
  if (!over && !command.wait_cancelled) return Progress::again;
  if (said == 0 && command.say("//action:prompt_end") == Progress::again) {
    return Progress::again;
  }
  said = 1;
  return pauses ? command.say("//action:resumed") : Progress::done;
}

// M118 [A1] [E1] text: A1 makes it an action command, E1 an echo.
Progress HostCommands::say_text(ActiveCommand& command) {
  std::string_view text = command.command.text;
  bool action = false;
  bool echo = false;
  const auto takes = [&text](std::string_view prefix) {
    if (text.size() < 2 || text[0] != prefix[0] || text[1] != prefix[1]) return false;
    text.remove_prefix(2);
    units::LoopBound<units::longest_text> blanks;
    while (!text.empty() && text.front() == ' ') {
      blanks.next();
      text.remove_prefix(1);
      units::happens<units::Event::character_read>(text.size());
    }
    return true;
  };
  units::EventBound<units::Event::character_read, units::longest_text> read;
  // Each takes two bytes of the line, but the last.
  units::LoopBound<units::longest_text / 2 + 1> words;
  for (bool more = true; more;) {
    const bool is_action = takes("A1");
    words.next();
    const bool is_echo = !is_action && takes("E1");
    action |= is_action;
    echo |= is_echo;
    more = is_action || is_echo || takes("P0");
  }
  host_link::TextLine line;
  if (echo || (!action && reads_as_answer(text))) line.text("echo:");
  if (action) {
    line.text("//");
  }
  return command.say(line.text(text));
}

Progress HostCommands::stop_everything(ActiveCommand& command) {
  return command.end_everything({.reason = Fatal::Reason::asked_for});
}

Progress HostCommands::set_busy_interval(ActiveCommand& command) {
  busy_interval_ = command.seconds().value_or(busy_interval_);
  link_.set_busy_interval(busy_interval_);
  return Progress::done;
}

Progress HostCommands::report_busy_interval(ActiveCommand& command) {
  return report_seconds(command, busy_interval_);
}

Progress HostCommands::set_inactivity(ActiveCommand& command) {
  inactivity_ = command.seconds().value_or(inactivity_);
  return Progress::done;
}

Progress HostCommands::report_inactivity(ActiveCommand& command) {
  return report_seconds(command, inactivity_);
}

Progress HostCommands::set_host_silence(ActiveCommand& command) {
  host_silence_ = command.seconds().value_or(host_silence_);
  return Progress::done;
}

Progress HostCommands::report_host_silence(ActiveCommand& command) {
  return report_seconds(command, host_silence_);
}

// M486 P, C and U, and EXCLUDE_OBJECT itself, leave a part out.
Progress HostCommands::note_object(ActiveCommand& command) {
  const std::string_view text = command.command.text;
  const char first = text.empty() ? '\0' : static_cast<char>(text.front() & ~0x20);
  if (first == 'P' || first == 'C' || first == 'U' || first == 'N') {
    return command.refuse("Objects cannot be left out");
  }
  if (objects_noted_ || command.say("echo:Names of objects are ignored") == Progress::done) {
    objects_noted_ = true;
    return Progress::done;
  }
  return Progress::again;
}

Progress HostCommands::set_progress(ActiveCommand& command) {
  percent_done_ = static_cast<std::uint8_t>(command.integer('P').value_or(percent_done_));
  time_left_ = static_cast<std::uint16_t>(command.integer('R').value_or(time_left_));
  return Progress::done;
}

// In Marlin's words.
Progress HostCommands::report_progress(ActiveCommand& command) {
  host_link::TextLine line;
  line.text("echo: M73 Progress: ").integer(percent_done_).text("%; Time left: ");
  return command.say(line.integer(time_left_).text("m;"));
}

// A G code would have moved something, and so counts as refused.
Progress HostCommands::refuse_end_stops(ActiveCommand& command) {
  return command.refuse("End stops end homing only");
}

Progress HostCommands::refuse_repeats(ActiveCommand& command) {
  return command.refuse("No repeats, the lines after it are executed once");
}

// The loader answers from then on; control does not return here.
Progress HostCommands::update_firmware(ActiveCommand& command) {
  if (platform::enter_boot_loader()) return Progress::done;
  return command.refuse("No boot loader in this image");
}

}  // namespace application
