// SPDX-License-Identifier: Apache-2.0
// One pass of the loop: the tasks in turn, and what waits while motion needs lines.
#include <algorithm>
#include <array>
#include <cstdint>

#include "application/application.hpp"
#include "application/task_table.hpp"
#include "host_link/replies.hpp"
#include "units/event_bound.hpp"
#include "units/task_span.hpp"

namespace application {
namespace {

// A tick of the clock is a millisecond.
constexpr std::int32_t ticks_at_work = task_timing::sleep_at_work.count();
constexpr std::int32_t ticks_at_rest = task_timing::sleep_at_rest.count();

using units::Task;

constexpr auto needs = [] {
  std::array<std::uint8_t, units::task_count> parts{};
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = part_of(static_cast<Task>(i));
  return parts;
}();

// What a task says, two lines at most: the queue's bytes, and the texts that they come from; how
// many of its numbers may need more than 32 bits.
template <std::uint32_t long_digits>
struct WordsBound {
  units::EventBound<units::Event::byte_queued, host_link::TextLine::capacity * 2> bytes;
  units::EventBound<units::Event::character_written, host_link::TextLine::capacity * 3> characters;
  units::EventBound<units::Event::long_digit, long_digits> digits;
};

}  // namespace

template <units::Task task, class Work>
auto Application::run(const Work& work) {
  struct Slice {
    ~Slice() { watch.end(task); }
    TaskWatch& watch;
  };
  const Slice slice{task_watch_};
  const units::TaskSpan<task> span;
  return work();
}

bool Application::update() {
  const units::Cycles began = hardware_.timer.now();
  task_watch_.begin_pass(began);
  const Now now = clock_.update(began);
  bool more = false;
  units::EventBound<units::Event::long_work, 1> works;
  units::EventBound<units::Event::read_or_executed, 1> reads;
  units::EventBound<units::Event::received_or_executed, 1> receives;
  units::EventBound<units::Event::answered_or_executed, 1> answers;
  units::EventBound<units::Event::planned_or_executed, 1> plans;
  if (halted_) {
    serve_halted(now);
    transmit();
    // No task's time: nothing waits for any.
    task_watch_.begin_pass(hardware_.timer.now());
  } else {
    run<Task::motion>([&] { motion_.update(now); });
    more = work(now);
    if (run<Task::refill>([&] { return refill(); })) more = true;
    // What a fault has to say is sent in the next pass.
    more = more || executor_.has_got_room() || halted_;
  }
  run<Task::rest>([&] {
    heat_.complete_feed();
    count(now);
    const std::uint32_t pass =
        hardware_.timer.now_low() - static_cast<std::uint32_t>(began.count());
    counters_.longest_pass_clocks = std::max(counters_.longest_pass_clocks, pass);
    if (more) return;
    set_alarms();
  });
  return more;
}

// The rest of a round: each task in its turn, until one must wait, or heat has taken long; commands
// also wait for the next pass where a task before has had work. True if there is more to do.
bool Application::work(const Now& now) {
  if (motion_.collecting()) return true;
  bool has_worked = false;
  switch (next_) {
    default:
      if (!may_begin(Task::serial_line)) return true;
      has_worked = run<Task::serial_line>([&] {
        const bool exchanges = exchange_bytes(now);
        act_on_emergencies();
        return exchanges;
      });
      if (halted_) return true;
      [[fallthrough]];
    case Task::faults:
      if (!may_begin(Task::faults)) return true;
      run<Task::faults>([&] {
        const WordsBound<0> words;
        look_for_faults();
      });
      if (halted_) return true;
      [[fallthrough]];
    case Task::heat:
      if (heat_.is_due(now.milliseconds)) {
        if (!may_begin(Task::heat)) return true;
        run<Task::heat>([&] {
          units::happens<units::Event::long_work>();
          const Now then = clock_.update(hardware_.timer.now());
          note_cooling(then);
          heat_.update(then);
        });
        next_ = Task::planning;
        return true;
      }
      [[fallthrough]];
    case Task::planning:
      if (!may_begin(Task::planning)) return true;
      if (run<Task::planning>([&] { return motion_.plan(now); })) has_worked = true;
      [[fallthrough]];
    case Task::reports:
      if (!may_begin(Task::reports)) return true;
      next_ = Task::commands;
      if (run<Task::reports>([&] {
            const WordsBound<host_link::long_digits_of_position> words;
            return report(now);
          }) ||
          has_worked) {
        return true;
      }
      [[fallthrough]];
    case Task::commands:
      if (!may_begin(Task::commands)) return true;
  }
  next_ = {};
  return run<Task::commands>([&] {
    units::happens<units::Event::long_work>();
    units::happens<units::Event::read_or_executed>();
    units::happens<units::Event::received_or_executed>();
    units::happens<units::Event::answered_or_executed>();
    units::happens<units::Event::planned_or_executed>();
    // What has come is taken first where there is room for it: it may be a line that needs no turn.
    const bool looks_first =
        hardware_.uart.line_waits() && link_.waiting_lines() < host_link::LineQueue::capacity;
    const bool more = looks_first || executor_.update(now);
    counters_.lines_withdrawn = link_.statistics().withdrawn;
    // The host may send its next line during the rest of the pass.
    transmit();
    return more;
  });
}

// True if there may be more. By the time before each line, so that what is due at the end is in
// hand when the next pass begins.
bool Application::refill() {
  // Nothing is appended meanwhile.
  units::EventBound<units::Event::looked_ahead, 1> once;
  // Those of a line before, and of those that begin.
  constexpr auto most_segments = (task_timing::lines_of_a_refill + 1) * motion::most_phases;
  units::EventBound<units::Event::segment_made, most_segments> segments;
  units::LoopBound<task_timing::lines_of_a_refill> lines;
  units::Cycles began;
  bool more = true;
  for (unsigned i = 0; more && i < task_timing::lines_of_a_refill; ++i) {
    lines.next();
    began = hardware_.timer.now();
    more = motion_.refill(clock_.update(began).microseconds);
  }
  const std::int32_t in_hand = motion_.time_in_hand();
  in_haste_ = in_hand != MotionTask::no_haste;
  in_hand_until_ = static_cast<std::uint32_t>(began.count()) +
                   clock_.clocks_in(static_cast<std::uint32_t>(std::max<std::int32_t>(in_hand, 0)));
  return more;
}

// Whether motion does not end before the task has: otherwise it is the next one. By the time at
// which the task before has ended.
bool Application::may_begin(Task task) {
  next_ = task;
  return !in_haste_ || left_in_hand() >= need_of(task);
}

std::int32_t Application::need_of(Task task) const {
  return static_cast<std::int32_t>(longest_pass_clocks_ * needs[static_cast<std::size_t>(task)] /
                                   whole_need);
}

std::int32_t Application::left_in_hand() const {
  return static_cast<std::int32_t>(in_hand_until_ - task_watch_.last());
}

// The events that end the sleep after this pass. Motion ends it before it needs its next line.
void Application::set_alarms() {
  const bool at_rest = halted_ || (executor_.can_wait() && !motion_.queue_full());
  std::int32_t ticks = at_rest ? ticks_at_rest : ticks_at_work;
  if (in_haste_) {
    const auto kept = static_cast<std::int32_t>(longest_pass_clocks_);
    const std::int32_t left =
        left_in_hand() - (motion_.queue_full() ? need_of(Task::refill) : kept);
    if (left < 0) {
      ticks = 0;
    } else {
      const std::uint32_t most = clock_.ticks_in(static_cast<std::uint32_t>(left));
      ticks = std::min(ticks, static_cast<std::int32_t>(most));
    }
  }
  hardware_.uart.interrupt_on({.receive_level = task_timing::wake_level, .line_end = true});
  hardware_.timer.set_deadline(clock_.in_ticks(static_cast<std::uint32_t>(ticks)));
}

}  // namespace application
