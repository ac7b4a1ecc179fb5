// SPDX-License-Identifier: Apache-2.0
// Takes lines, finds the handler of each command, and sends the ok when it is done.
#include "application/command_executor.hpp"

#include "gcode/parser.hpp"
#include "host_link/replies.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

// One update says a line, or some short ones, and its ok, which may report something.
constexpr std::uint32_t most_bytes_said = 2 * host_link::TextLine::capacity;
// Of the texts that it puts together: what it says, a line that finds no room in the queue, and
// parts of them that are put together before.
constexpr std::uint32_t most_characters = most_bytes_said + 3 * host_link::TextLine::capacity;
// Of all its numbers.
constexpr std::uint32_t most_long_digits = 10;

}  // namespace

CommandExecutor::CommandExecutor(const MachineDescription& machine, MotionTask& motion,
                                 HeatTask& heat, drivers::Fan& fan, host_link::HostLink& link,
                                 Statistics& counters, FilamentCommands* filament)
    : motion_(motion),
      link_(link),
      counters_(counters),
      groups_(machine, motion, heat, fan, link, counters, filament),
      active_(link),
      query_(link) {}

bool CommandExecutor::update(const Now& now) {
  units::EventBound<units::Event::byte_queued, most_bytes_said> replies;
  units::EventBound<units::Event::character_written, most_characters> characters;
  units::EventBound<units::Event::long_digit, most_long_digits> digits;
  units::EventBound<units::Event::handler_called, 1> handlers;
  units::EventBound<units::Event::refused, 1> refusals;
  units::EventBound<units::Event::settled, 1> ends;
  active_.now = now;
  follow_position_jump();
  if (answer_query()) return true;
  if (groups_.handles_filament()) {
    // While it is changed it may be away, and where lines are not executed, M600 is none either.
    const bool ignores = asks_user() || groups_.files.storing() || groups_.dry_runs.asked_for();
    ignores ? groups_.filament().reset() : groups_.filament().watch(now.milliseconds);
  }
  if (stage_ == Stage::idle && !take_line()) return false;
  if (stage_ == Stage::executing) {
    if (held_ && begins()) return false;
    if (proceed() == Progress::again || fatal()) return false;
    stage_ = Stage::answering;
  }
  if (groups_.handles_filament() && is_own_) {
    is_own_ = false;
    groups_.filament().reset();
    stage_ = Stage::idle;
    return link_.waiting_lines() != 0;
  }
  if (!link_.finished(active_.behind_ok.view())) return false;
  ++(active_.refused ? counters_.commands_refused : counters_.commands_executed);
  stage_ = Stage::idle;
  return link_.waiting_lines() != 0;
}

bool CommandExecutor::has_got_room() const {
  return motion_.has_room() && (appends() || (waits_for_room_ && begins() && !held_));
}

void CommandExecutor::quick_stop() {
  motion_.quick_stop();
  active_.wait_cancelled = true;
}

void CommandExecutor::hold(bool held) {
  held_ = held;
  motion_.hold(held);
}

// The host's //action:cancel: what waits in the queue belongs to what is cancelled.
void CommandExecutor::cancel_lines() {
  quick_stop();
  hold(false);
  if (groups_.handles_filament()) groups_.filament().cancel();
  cancelled_lines_ = link_.waiting_lines();
  if (stage_ == Stage::idle || (groups_.handles_filament() && is_own_)) return;
  --cancelled_lines_;
  if (begins()) stage_ = Stage::answering;
}

host_link::Activity CommandExecutor::activity() const {
  using host_link::Activity;
  if (held_ || asks_user()) return Activity::paused_for_user;
  return stage_ == Stage::idle ? Activity::idle : Activity::processing;
}

bool CommandExecutor::take_line() {
  // What M600 does, between two lines of the host.
  const bool is_own = groups_.handles_filament() && groups_.filament().has_run_out();
  if (is_own && active_.say("echo:Filament has run out") == Progress::again) return false;
  const auto line =
      is_own ? std::optional<host_link::AcceptedLine>({"M600", {}, false}) : link_.next_line();
  if (!line) return false;
  if (groups_.handles_filament()) is_own_ = is_own;
  active_.begin(line->text);
  parse_error_.reset();
  const bool cancelled = !is_own && cancelled_lines_ != 0;
  if (cancelled) --cancelled_lines_;
  active_.refused = cancelled && !line->emergency;
  stage_ = line->emergency || cancelled ? Stage::answering : parse(line->text);
  if (!parse_error_ || !link_.ask_again()) return true;
  stage_ = Stage::idle;
  return false;
}

// The first stage of the line.
CommandExecutor::Stage CommandExecutor::parse(std::string_view text) {
  const auto error = gcode::parse(text, active_.command);
  if (!error) {
    find_row();
    return Stage::executing;
  }
  if (error->fault == gcode::ParseFault::empty_line) return Stage::answering;
  parse_error_ = error;
  return Stage::executing;
}

// A print repeats the same command many times.
void CommandExecutor::find_row() {
  if (row_ == nullptr || !row_->is_of(active_.command)) row_ = find_entry(active_.command);
  active_.limits = row_ != nullptr ? row_->limits() : ArgumentLimits{};
}

Progress CommandExecutor::proceed() {
  if (parse_error_) return refuse_unparsed();
  if (begins()) {
    if (const auto progress = prepare()) return *progress;
  }
  const Progress progress = row_->handler()(groups_, active_);
  units::happens<units::Event::handler_called>();
  return progress;
}

Progress CommandExecutor::refuse_unparsed() {
  using gcode::ParseFault;
  if (parse_error_->fault == ParseFault::unknown_letter ||
      parse_error_->fault == ParseFault::missing_code) {
    return active_.refuse_unknown();
  }
  return active_.refuse(host_link::not_executed(gcode::describe(*parse_error_),
                                                parse_error_->position, active_.text));
}

// Returns nothing if the handler is to be called. Called in each pass until the handler has begun
// something that cannot be undone.
std::optional<Progress> CommandExecutor::prepare() {
  const gcode::Command& command = active_.command;
  if (groups_.files.storing() && (row_ == nullptr || !row_->while_storing)) {
    return FileCommands::refuse_to_store(active_);
  }
  if (groups_.dry_runs.asked_for() && (row_ == nullptr || !row_->while_dry_run)) {
    return groups_.dry_runs.refuse_line(active_);
  }
  if (row_ == nullptr || !row_->has_handler()) return active_.refuse_unknown();
  if (command.letter != 'T' && command.subcode > row_->most_subcode) {
    return active_.refuse_unknown();
  }
  if (row_->refuses_others && command.has_besides(row_->letters())) {
    return active_.refuse("Unknown parameter");
  }
  if (const Handler report = row_->report();
      report != nullptr && !command.has_any(row_->letters())) {
    const Progress progress = report(groups_, active_);
    units::happens<units::Event::handler_called>();
    return progress;
  }
  if (!may_start()) return Progress::again;
  if (const auto* limit = violated(command, active_.limits)) return active_.refuse(*limit);
  return std::nullopt;
}

bool CommandExecutor::may_start() {
  waits_for_room_ = false;
  switch (row_->start) {
    case Start::in_turn:
      return true;
    case Start::with_room:
      waits_for_room_ = !motion_.has_room();
      return !waits_for_room_ && !motion_.stopping();
    case Start::at_rest_but_with_s:
      if (active_.command.has_number('S')) return true;
      [[fallthrough]];
    case Start::at_rest:
      motion_.flush();
      return motion_.at_rest();
  }
  return true;
}

// One ahead of the current line, which may have to wait long; it is then all that a pass does.
bool CommandExecutor::answer_query() {
  const auto code = link_.query();
  if (!code || !link_.has_room_for_answer()) return false;
  if (groups_.reports.must_wait(*code, active_.now.milliseconds)) return false;
  const Progress progress = groups_.reports.answer_ahead(*code, query_, active_.now.milliseconds);
  if (progress == Progress::done && link_.query_answered(query_.behind_ok.view())) query_.begin();
  return true;
}

void CommandExecutor::follow_position_jump() {
  if (motion_.position_jumps() == position_jumps_) return;
  position_jumps_ = motion_.position_jumps();
  groups_.coordinates.follow(motion_.position());
}

}  // namespace application
