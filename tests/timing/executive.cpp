// SPDX-License-Identifier: Apache-2.0
// Nothing here is taken from the analysis: events happen, tasks look, times are read off.
#include "tests/timing/executive.hpp"

#include <algorithm>

namespace timing {

namespace {

using units::Task;

// Start bit, 8 data bits, stop bit; 3 % faster than it should be is what a receiver follows.
constexpr std::uint64_t frame_bits = 10, fastest_percent = 103;

std::size_t index_of(Task task) { return static_cast<std::size_t>(task); }

class Executive {
 public:
  Executive(const Facts& facts, Rate rate, const Passes& run)
      : facts_(facts), rate_(rate), run_(run), ms_(rate.clock_hz / 1000) {}

  const Pass& pass(std::size_t k) const { return run_[std::min(k, run_.size() - 1)]; }

  // From the end of one run of a task to that of the next.
  Clocks gap(Task task) const {
    const Clocks ends = pass(0).length + pass(0).sleep + pass(1).looks[index_of(task)];
    return ends - pass(0).looks[index_of(task)];
  }

  // Of an event right after `first` has looked: until `last` has in the pass of the next such look
  // but `more`.
  Clocks response(Task first, Task last, std::size_t more) const {
    Clocks time = 0;
    for (std::size_t k = 0; k <= more; ++k) time += pass(k).length;
    return time + pass(more + 1).looks[index_of(last)] - pass(0).looks[index_of(first)] - 1;
  }

  std::size_t more_looks(std::uint64_t bytes) const {
    std::size_t more = 0;
    for (; bytes > facts_.bytes_of_a_look; ++more) bytes -= facts_.bytes_of_a_look;
    return more;
  }

  std::uint64_t most_bytes() const;
  Clocks sign_of_life() const;
  Clocks next_line() const;
  // From one feeding to the next: of both keys, or of the first.
  Clocks late_heater_feed() const;
  Clocks early_heater_feed() const;

 private:
  Clocks floor_ms(Clocks time) const { return time / ms_; }
  // A time in parts of a clock in which the times of bytes are whole.
  std::uint64_t parts(Clocks clocks) const { return clocks * rate_.baud * fastest_percent; }
  std::uint64_t byte_parts() const { return 100 * frame_bits * rate_.clock_hz; }

  const Facts& facts_;
  Rate rate_;
  const Passes& run_;
  Clocks ms_;
};

// A host that sends as fast as it can, but stops with so many bytes unanswered. Its first byte has
// come in right after a look that has left nothing.
std::uint64_t Executive::most_bytes() const {
  std::uint64_t next = parts(pass(0).looks[index_of(Task::serial_line)]);
  std::uint64_t level = 0, most = 0;
  const auto receive = [&](Clocks until) {
    if (next > parts(until)) return;
    const std::uint64_t bytes = (parts(until) - next) / byte_parts() + 1;
    next += bytes * byte_parts();
    level = std::min(level + bytes, facts_.unanswered_bytes);
  };
  Clocks begin = 0;
  for (std::size_t k = 0; k < 1'000 && most < facts_.unanswered_bytes; ++k) {
    if (k != 0) {
      receive(begin + pass(k).looks[index_of(Task::serial_line)]);
      most = std::max(most, level);
      level -= std::min(level, facts_.bytes_of_a_look);
    }
    begin += pass(k).length;
    receive(begin);
    if (level >= facts_.wake_level) continue;
    // Asleep until enough bytes have come, or so long.
    const std::uint64_t wake = next + (facts_.wake_level - level - 1) * byte_parts();
    begin = std::max(begin, std::min(begin + pass(k).sleep, wake / parts(1) + 1));
  }
  return most;
}

// Without the time after which the busy message is due.
Clocks Executive::sign_of_life() const {
  const Clocks due_ms = 50;  // any
  const std::size_t more = more_looks(facts_.bytes_of_a_line);
  Clocks accepted = 0;  // the pass's begin, which is its time
  for (std::size_t k = 0; k <= more; ++k) accepted += pass(k).length;
  const Clocks arrived = pass(0).looks[index_of(Task::serial_line)];
  // A pass begins in the last clock before it is due.
  const Clocks due = (accepted / ms_ + due_ms) * ms_;
  const Clocks begin = due - 1 + pass(0).length + pass(0).sleep;
  const Clocks written = begin + pass(1).refill_begins;
  const Clocks wire = facts_.busy_message_bytes * frame_bits * rate_.clock_hz / rate_.baud;
  return written + wire - arrived - due_ms * ms_;
}

// How long what pass 0 has handed over must last.
Clocks Executive::next_line() const {
  const Clocks begin = pass(0).length + pass(0).sleep;
  Clocks longest = 0, later = 0;
  for (const Clocks line : pass(1).lines) {
    if (begin + line > later) longest = std::max(longest, begin + line - later);
    later += facts_.least_line_clocks;
  }
  return longest;
}

// The heat task: a round each period, and the last turn in it feeds. Between the moments that count
// passes are as short as need be, so that one begins in the last clock before one is due.
Clocks Executive::late_heater_feed() const {
  const Clocks gap = pass(0).length + pass(0).sleep;
  const auto first_from = [&](Clocks due) { return gap == 0 ? due : due - 1 + gap; };
  const Clocks half = facts_.heat_period_ms / 2;
  const Clocks fed_0 = (floor_ms(ms_ - 1) + half) * ms_;
  const Clocks due_1 = std::max((floor_ms(ms_ - 1) + facts_.heat_period_ms) * ms_, fed_0);
  const Clocks turn_1 = first_from((floor_ms(first_from(due_1)) + half) * ms_);
  return turn_1 + pass(1).length - fed_0;
}

// It looks when it begins, in the last clock of a millisecond, and feeds when it is done; the next
// time it is at once.
Clocks Executive::early_heater_feed() const {
  const std::size_t heat = index_of(Task::heat);
  const Clocks looked = ms_ - 1;
  const Clocks fed_0 = looked + pass(1).looks[heat] - pass(1).looks[heat - 1];
  return (floor_ms(looked) + facts_.least_heat_ms) * ms_ - fed_0;
}

}  // namespace

std::optional<std::uint64_t> longest_in(Requirement requirement, const Facts& facts,
                                        const Load& load, Rate rate, const Passes& run) {
  const Executive executive(facts, rate, run);
  switch (requirement) {
    case Requirement::received_bytes:
      return executive.most_bytes();
    case Requirement::sign_of_life:
      return executive.sign_of_life();
    case Requirement::stop_by_host: {
      const auto bytes = respond(Requirement::received_bytes, facts, load, rate).worst;
      return executive.response(Task::serial_line, Task::serial_line, executive.more_looks(*bytes));
    }
    case Requirement::emergency_stop:
      return executive.response(Task::motion, Task::faults, 0);
    case Requirement::motion_watchdog:
      return executive.gap(Task::motion);
    case Requirement::horizon:
    case Requirement::queue:
      return executive.next_line();
    case Requirement::heater_watchdog:
      return executive.late_heater_feed();
    case Requirement::not_too_early:
      return executive.early_heater_feed();
    case Requirement::bits:
    case Requirement::count:
      break;
  }
  return std::nullopt;
}

Passes random_run(const Facts& facts, const Load& load, Rate rate, std::mt19937& random) {
  const auto part = [&](Clocks most) -> Clocks {
    const unsigned choice = std::uniform_int_distribution<unsigned>(0, 3)(random);
    if (choice < 2) return choice == 0 ? 0 : most;
    return std::uniform_int_distribution<Clocks>(0, most)(random);
  };
  Passes run(6);
  for (Pass& pass : run) {
    Clocks time = 0;
    for (std::size_t task = 0; task < units::task_count; ++task) {
      const Clocks longest = *load.ends[task] - *load.begins[task];
      const bool is_refill = task == index_of(Task::refill);
      if (is_refill) pass.refill_begins = time;
      const Clocks before = time;
      time += part(longest);
      pass.looks[task] = time;
      for (int line = 0; is_refill && line < 5; ++line) {
        pass.lines.push_back(pass.lines.empty()
                                 ? before + part(time - before)
                                 : pass.lines.back() + part(time - pass.lines.back()));
      }
    }
    pass.length = time + part(*load.pass - time);
    pass.sleep = part(facts.sleep_ms * rate.clock_hz / 1000);
  }
  return run;
}

Passes worst_run(const Facts& facts, const Load& load, Rate rate) {
  const Clocks sleep = facts.sleep_ms * rate.clock_hz / 1000;
  const Pass first{.length = *load.pass, .sleep = sleep};
  Pass other{.length = *load.pass, .sleep = sleep};
  for (std::size_t task = 0; task < units::task_count; ++task) other.looks[task] = *load.ends[task];
  other.refill_begins = *load.begins[index_of(Task::refill)];
  other.lines = {other.looks[index_of(Task::refill)], other.looks[index_of(Task::refill)],
                 other.looks[index_of(Task::refill)]};
  return {first, other};
}

}  // namespace timing
