// SPDX-License-Identifier: Apache-2.0
// One pass of the loop: the tasks in order, and what waits while motion needs lines.
#include <algorithm>

#include "application/application.hpp"
#include "units/event_bound.hpp"
#include "units/task_span.hpp"

namespace application {
namespace {

// A tick of the clock is a millisecond.
constexpr std::int32_t ticks_at_work = task_timing::sleep_at_work.count();
constexpr std::int32_t ticks_at_rest = task_timing::sleep_at_rest.count();

using units::Task;

template <Task task, class Work>
auto run(const Work& work) {
  const units::TaskSpan<task> span;
  return work();
}

// What a task says: the queue's bytes, and the texts that they come from.
struct WordsBound {
  units::EventBound<units::Event::byte_queued, host_link::TransmitQueue::capacity> bytes;
  units::EventBound<units::Event::character_written, host_link::TextLine::capacity * 3> characters;
  units::EventBound<units::Event::long_digit, 0> digits;
};

}  // namespace

bool Application::update() {
  const units::Cycles began = hardware_.timer.now();
  const Now now = clock_.update(began);
  bool more = false;
  if (halted_) {
    serve_halted(now);
    transmit();
  } else {
    run<Task::motion>([&] { motion_.update(now); });
    const std::optional<bool> worked = work(now);
    const unsigned most = worked ? task_timing::lines_behind_work : task_timing::lines_alone;
    more = run<Task::refill>([&] { return motion_.refill(most); });
    // What a fault has to say is sent in the next pass.
    more = more || worked.value_or(true) || executor_.has_got_room() || halted_;
  }
  run<Task::rest>([&] {
    heat_.complete_feed();
    count(now);
    const auto pass = static_cast<std::uint32_t>((hardware_.timer.now() - began).count());
    counters_.longest_pass_clocks = std::max(counters_.longest_pass_clocks, pass);
    if (!more) set_alarms(now);
  });
  return more;
}

// Nothing where work is put off because motion needs lines; otherwise whether there is more to do
// at once. What has come too late goes before the serial line in a later pass.
std::optional<bool> Application::work(Now now) {
  const units::Microseconds in_hand = motion_.time_in_hand();
  ends_in_hand_ = now.microseconds + in_hand;
  if (!work_is_late_ && in_hand >= time_for_look_) {
    run<Task::serial_line>([&] {
      exchange_bytes(now);
      act_on_emergencies();
    });
    if (halted_) return false;
  }
  work_is_late_ = false;
  if (motion_.collecting()) return std::nullopt;
  if (!in_time()) return std::nullopt;
  run<Task::faults>([&] {
    const WordsBound words;
    look_for_faults();
  });
  if (halted_) return false;
  if (heat_.is_due(now.milliseconds)) {
    run<Task::heat>([&] {
      const Now then = time();
      note_cooling(then);
      heat_.update(then);
    });
    if (!in_time()) return std::nullopt;
  }
  run<Task::planning>([&] { motion_.plan(now); });
  run<Task::reports>([&] {
    const WordsBound words;
    report(now);
  });
  if (halted_) return false;
  // What has come is taken first where there is room for it: it may be a line that needs no turn.
  if (hardware_.uart.line_waits() && link_.waiting_lines() < host_link::LineQueue::capacity) {
    return true;
  }
  if (!in_time()) return std::nullopt;
  return run<Task::commands>([&] {
    const bool more = executor_.update(now);
    counters_.lines_withdrawn = link_.statistics().withdrawn;
    // The host may send its next line during the rest of the pass.
    transmit();
    return more;
  });
}

bool Application::in_time() {
  work_is_late_ = ends_in_hand_ - time().microseconds < time_for_work_;
  return !work_is_late_;
}

Now Application::time() { return clock_.update(hardware_.timer.now()); }

// The events that end the sleep after this pass. Motion ends it before it needs its next line.
void Application::set_alarms(Now now) {
  const bool at_rest = halted_ || (executor_.can_wait() && !motion_.queue_full());
  std::int32_t ticks = at_rest ? ticks_at_rest : ticks_at_work;
  const units::Microseconds ends = now.microseconds + motion_.time_in_hand() - longest_pass_;
  const std::int64_t left = (ends - time().microseconds).count();
  if (left < ticks * 1000) ticks = left < 0 ? 0 : static_cast<std::int32_t>(left) / 1000;
  hardware_.uart.interrupt_on({.receive_level = task_timing::wake_level, .line_end = true});
  hardware_.timer.set_deadline(clock_.in_ticks(static_cast<std::uint32_t>(ticks)));
}

}  // namespace application
