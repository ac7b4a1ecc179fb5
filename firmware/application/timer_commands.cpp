// SPDX-License-Identifier: Apache-2.0
// Counts the time of prints, and reports it in Marlin's words.
#include "application/timer_commands.hpp"

#include <algorithm>

namespace application {
namespace {

// "1d 2h 3m 4s", from the first part that is not 0 on.
void put_duration(host_link::TextLine& line, units::Milliseconds duration) {
  auto left = static_cast<std::uint32_t>(duration.count() / 1000);
  struct Unit {
    std::uint32_t seconds;
    char letter;
  };
  static constexpr Unit units_of_time[]{{24 * 3600, 'd'}, {3600, 'h'}, {60, 'm'}, {1, 's'}};
  bool begun = false;
  for (const Unit& unit : units_of_time) {
    const std::uint32_t count = left / unit.seconds;
    left -= count * unit.seconds;
    if (count == 0 && !begun && unit.seconds != 1) continue;
    if (begun) line.character(' ');
    line.integer(count).character(unit.letter);
    begun = true;
  }
}

}  // namespace

units::Milliseconds TimerCommands::duration(units::Milliseconds now) const {
  return state_ == State::running ? counted_ + (now - began_) : counted_;
}

void TimerCommands::begin(units::Milliseconds now) {
  if (state_ == State::running) return;
  if (state_ == State::stopped) {
    counted_ = {};
    ++prints_;
  }
  began_ = now;
  state_ = State::running;
}

void TimerCommands::end(units::Milliseconds now) {
  if (state_ == State::stopped) return;
  counted_ = duration(now);
  state_ = State::stopped;
  ++finished_;
  total_ += counted_;
  longest_ = std::max(longest_, counted_);
}

Progress TimerCommands::start(ActiveCommand& command) {
  begin(command.now.milliseconds);
  return Progress::done;
}

Progress TimerCommands::pause(ActiveCommand& command) {
  if (state_ != State::running) return Progress::done;
  counted_ = duration(command.now.milliseconds);
  state_ = State::paused;
  return Progress::done;
}

Progress TimerCommands::stop(ActiveCommand& command) {
  end(command.now.milliseconds);
  return Progress::done;
}

Progress TimerCommands::report_time(ActiveCommand& command) {
  host_link::TextLine line;
  put_duration(line.text("echo:Print time: "), duration(command.now.milliseconds));
  return command.say(line);
}

Progress TimerCommands::report_statistics(ActiveCommand& command) {
  if (command.integer('S') == 78) {
    prints_ = finished_ = 0;
    total_ = longest_ = {};
    return Progress::done;
  }
  host_link::TextLine line;
  if (command.lines_said == 0) {
    const std::uint32_t under_way = state_ == State::stopped ? 0 : 1;
    line.text("Stats: Prints: ").integer(prints_).text(", Finished: ").integer(finished_);
    line.text(", Failed: ").integer(std::int64_t{prints_} - finished_ - under_way);
    if (command.say(line) == Progress::again) return Progress::again;
    command.lines_said = 1;
    line.clear();
  }
  put_duration(line.text("Stats: Total time: "), total_);
  put_duration(line.text(", Longest job: "), longest_);
  return command.say(line);
}

}  // namespace application
