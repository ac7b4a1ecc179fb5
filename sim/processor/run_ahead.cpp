// SPDX-License-Identifier: Apache-2.0
// Sleep and interrupts, and the rollback when an interrupt line changes.
#include <algorithm>

#include "sim/processor/processor_model.hpp"
#include "sim/processor/times.hpp"

namespace processor {

void ProcessorModel::mark() {
  marked_ = state_;
  marked_complete_ = complete_;
  stored_ = 0;
  full_ = sensitive_ = false;
  if (!change_waits_) change_.reset();
}

void ProcessorModel::take_back(Clock clock) {
  if (complete_ <= clock) return;
  state_ = marked_;
  complete_ = marked_complete_;
  while (stored_ > 0) {
    const Store& store = stores_[--stored_];
    put_word(store.place, store.word);
  }
  full_ = sensitive_ = false;
  change_waits_ = change_.has_value();
  if (clock > complete_) run(clock);
}

void ProcessorModel::bring_to(Clock clock) {
  take_back(clock);
  run(clock);
}

Clock ProcessorModel::run(Clock limit) {
  // Up to its edge the change has no effect, and nothing later may be executed.
  if (change_waits_ && limit > change_->now) apply_change();
  return run_with_these_lines(limit);
}

// What the old level of the lines does in the clock behind the edge, and the new one from then on.
void ProcessorModel::apply_change() {
  change_waits_ = false;
  lines_known_ = change_->now;
  run_with_these_lines(change_->now + 1);
  lines_known_ = std::numeric_limits<Clock>::max();
  state_.lines = change_->lines;
  state_.lines_seen = change_->seen;
}

void ProcessorModel::set_interrupts(Clock now, std::uint32_t lines) {
  if (lines == (change_waits_ ? change_->lines : state_.lines)) return;
  const Clock seen = now + 1 + times::interrupt_seen;
  if (sensitive_) take_back(now);
  if (complete_ < now) run(now);
  // Asleep, it has executed nothing since the sleep began, and may be woken now.
  if (state_.asleep) complete_ = std::min(complete_, std::max(now, state_.begins - 1));
  if (complete_ <= now) {
    mark();
    change_ = Change{.now = now, .lines = lines, .seen = seen};
    change_waits_ = true;
    return;
  }
  // What has been executed beyond `now` would have been so with these lines as well.
  state_.lines = lines;
  state_.lines_seen = seen;
  if (change_) {
    change_->lines = lines;
    change_->seen = seen;
  } else {
    marked_.lines = lines;
    marked_.lines_seen = seen;
  }
}

Clock ProcessorModel::run_with_these_lines(Clock limit) {
  full_ = false;
  for (;;) {
    if (state_.accesses) break;
    if (state_.asleep) {
      if (!sleep(limit)) break;
    } else if (interrupt_is_due()) {
      sensitive_ = true;
      if (take_interrupt(limit)) continue;
      if (!execute<true>(limit)) break;
    } else {
      sensitive_ = sensitive_ || state_.interrupt_enable;
      if (!execute<false>(limit)) break;
    }
  }
  // Where the list is full, nothing that begins later has been executed.
  complete_ = std::max(complete_, full_ ? std::min(limit, state_.begins - 1) : limit);
  return complete_;
}

bool ProcessorModel::sleep(Clock limit) {
  if ((state_.lines & state_.interrupts_enabled) == 0) return false;
  const Clock begins = state_.begins, wakes = std::max(begins, state_.lines_seen);
  if (wakes > limit) return false;
  sensitive_ = true;
  state_.asleep = false;
  state_.slept_clocks += wakes - begins;
  ++state_.instructions;
  state_.program_counter += 4;
  state_.begins = wakes + 1;
  state_.open_from = std::max(state_.open_from, wakes + 1);
  state_.late_register = no_register;
  return true;
}

// The last clock in which the next instruction can be replaced by an interrupt.
Clock ProcessorModel::last_open_clock() {
  const std::uint32_t place = state_.program_counter - memory_start;
  if (place >= size_) return state_.begins;
  const Instruction& next = decoded_at(place);
  const bool waits = next.first == state_.late_register || next.second == state_.late_register;
  const Clock executes = state_.begins + (waits ? times::late_result_used : 0);
  switch (next.operation) {
    case Operation::wait_for_interrupt:
      return state_.begins - 1;
    case Operation::divide:
      return executes + times::division;
    default:
      return executes;
  }
}

bool ProcessorModel::take_interrupt(Clock limit) {
  const Clock clock = std::max(state_.open_from, state_.lines_seen);
  if (clock > limit || clock > last_open_clock()) return false;
  const std::uint32_t active = state_.lines & state_.interrupts_enabled;
  constexpr std::uint32_t interrupt = 1U << 31, external = 11, timer = 7;
  std::uint32_t cause = 16;
  if ((active >> external & 1) != 0) {
    cause = external;
  } else if ((active >> timer & 1) != 0) {
    cause = timer;
  } else {
    while ((active >> cause & 1) == 0) ++cause;
  }
  trap(interrupt | cause, 0, clock);
  return true;
}

std::uint64_t ProcessorModel::sleeping_clocks(Clock now) const {
  std::uint64_t clocks = state_.slept_clocks;
  if (state_.asleep) {
    // The output is seen after the edge before.
    Clock end = now + 2;
    if ((state_.lines & state_.interrupts_enabled) != 0) {
      end = std::min(end, std::max(state_.begins, state_.lines_seen));
    }
    clocks += end > state_.begins ? end - state_.begins : 0;
  }
  return clocks;
}

void ProcessorModel::trap(std::uint32_t cause, std::uint32_t value, Clock clock) {
  const bool interrupts = (cause >> 31) != 0;
  state_.exception_address = state_.program_counter;
  state_.trap_cause = cause;
  state_.trap_value = value;
  state_.previous_interrupt_enable = state_.interrupt_enable;
  state_.interrupt_enable = false;
  const bool vectored = (state_.trap_vector & 1) != 0 && interrupts;
  state_.program_counter = (state_.trap_vector & ~3U) + (vectored ? 4 * (cause & 31) : 0);
  state_.begins = clock + 1 + times::trap;
  state_.late_register = no_register;
  ++state_.traps;
}

}  // namespace processor
