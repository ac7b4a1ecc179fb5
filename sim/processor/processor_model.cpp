// SPDX-License-Identifier: Apache-2.0
// Time and memory: what waits for what, and what is taken back.
#include "sim/processor/processor_model.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include "sim/processor/times.hpp"

namespace processor {

namespace {

// From the first clock without reset to that of the first instruction.
constexpr Clock clocks_to_first_instruction = 3;

}  // namespace

ProcessorModel::ProcessorModel(std::uint32_t memory_bytes, bool has_zbb)
    : memory_(memory_bytes),
      size_(memory_bytes),
      has_zbb_(has_zbb),
      decoded_(memory_bytes / 2),
      holds_code_((memory_bytes >> code_block_shift) + 2) {}

void ProcessorModel::reset(Clock released) {
  MachineState state;
  state.registers = state_.registers;
  state.scratch = state_.scratch;
  state.exception_address = state_.exception_address;
  state.trap_value = state_.trap_value;
  state.instructions = state_.instructions;
  state.traps = state_.traps;
  state.slept_clocks = state_.slept_clocks;
  state.begins = released + clocks_to_first_instruction;
  state.open_from = state.begins;
  state.cycles.set(released, 0);
  state.retired.set(state.instructions, 0);
  state_ = state;
  complete_ = released;
  change_waits_ = false;
  mark();
}

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
  if (change_waits_) apply_change();
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
  // Asleep, it has done nothing since the sleep began, and may be woken now.
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

void ProcessorModel::begin_access(const Instruction& instruction, std::uint32_t address,
                                  Clock clock) {
  accessing_ = instruction;
  const bool is_store = instruction.operation >= Operation::store_byte;
  // Behind the three signed loads come the two unsigned ones.
  const auto size = is_store ? static_cast<unsigned>(instruction.operation) -
                                   static_cast<unsigned>(Operation::store_byte)
                             : (static_cast<unsigned>(instruction.operation) -
                                static_cast<unsigned>(Operation::load_byte)) %
                                   3;
  const unsigned bytes = 1U << size;
  constexpr std::array<std::uint32_t, 3> copies{0x0101'0101, 0x0001'0001, 1};
  const std::uint32_t data = state_.registers[instruction.second];
  const std::uint32_t mask = bytes == 4 ? ~std::uint32_t{0} : (1U << (8 * bytes)) - 1;
  access_ = {.address = address,
             .data = (data & mask) * copies[size],
             .lanes = static_cast<std::uint8_t>(((1U << bytes) - 1) << (address & 3)),
             .write = is_store};
  state_.accesses = true;
  state_.access_clock = clock;
}

void ProcessorModel::complete_access(Clock clock, bool is_refused, std::uint32_t word) {
  constexpr std::uint32_t load_access = 5, store_access = 7;
  if (change_waits_) apply_change();
  state_.accesses = false;
  if (is_refused) {
    trap(access_.write ? store_access : load_access, access_.address, clock);
  } else {
    const std::uint32_t value = word >> (8 * (access_.address & 3));
    std::uint32_t loaded = value;
    switch (accessing_.operation) {
      case Operation::load_byte:
        loaded = static_cast<std::uint32_t>(static_cast<std::int8_t>(value));
        break;
      case Operation::load_half:
        loaded = static_cast<std::uint32_t>(static_cast<std::int16_t>(value));
        break;
      case Operation::load_unsigned_byte:
        loaded = value & 0xff;
        break;
      case Operation::load_unsigned_half:
        loaded = value & 0xffff;
        break;
      default:
        break;
    }
    state_.late_register = no_register;
    if (!access_.write) {
      state_.registers[accessing_.destination] = loaded;
      state_.late_register = accessing_.destination;
    }
    ++state_.instructions;
    state_.program_counter += accessing_.bytes;
    state_.begins = clock + 1;
    state_.open_from = std::max(state_.open_from, clock + 1);
  }
  complete_ = clock;
  mark();
}

std::uint64_t ProcessorModel::sleeping_clocks(Clock now) const {
  std::uint64_t clocks = state_.slept_clocks;
  if (state_.asleep) {
    // The output is seen behind the edge before.
    Clock end = now + 2;
    if ((state_.lines & state_.interrupts_enabled) != 0) {
      end = std::min(end, std::max(state_.begins, state_.lines_seen));
    }
    clocks += end > state_.begins ? end - state_.begins : 0;
  }
  return clocks;
}

const Instruction& ProcessorModel::decoded_at(std::uint32_t place) {
  Instruction& instruction = decoded_[place >> 1];
  if (instruction.operation != Operation::undecoded) return instruction;
  std::uint16_t lower = 0, upper = 0;
  std::memcpy(&lower, &memory_[place], sizeof lower);
  const bool is_word = (lower & 3) == 3;
  const bool has_both = place + 2 < size_;
  if (is_word && has_both) std::memcpy(&upper, &memory_[place + 2], sizeof upper);
  instruction =
      decode(std::uint32_t{lower} | std::uint32_t{upper} << 16, memory_start + place, has_zbb_);
  if (is_word && !has_both) instruction = {.operation = Operation::fetch_fault};
  holds_code_[place >> code_block_shift] = 1;
  holds_code_[(place + 2) >> code_block_shift] = 1;
  return instruction;
}

void ProcessorModel::forget_code(std::uint32_t place, unsigned bytes) {
  const std::uint32_t first = place >> 1;
  const std::uint32_t last = (place + bytes - 1) >> 1;
  for (std::uint32_t i = first == 0 ? 0 : first - 1; i <= last; ++i) {
    decoded_[i].operation = Operation::undecoded;
  }
}

std::uint32_t ProcessorModel::word_at(std::uint32_t place) const {
  std::uint32_t word = 0;
  std::memcpy(&word, &memory_[place], sizeof word);
  return word;
}

void ProcessorModel::put_word(std::uint32_t place, std::uint32_t word) {
  std::memcpy(&memory_[place], &word, sizeof word);
  if (holds_code_[place >> code_block_shift] != 0) forget_code(place, sizeof word);
}

namespace {

std::uint32_t checked_place(std::uint32_t address, std::uint32_t size) {
  const std::uint32_t place = (address - ProcessorModel::memory_start) & ~3U;
  if (place < size) return place;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "no memory at %#010x", address);
  throw std::out_of_range(text.data());
}

}  // namespace

std::uint32_t ProcessorModel::read_memory(std::uint32_t address) const {
  return word_at(checked_place(address, size_));
}

void ProcessorModel::write_memory(std::uint32_t address, std::uint32_t word) {
  put_word(checked_place(address, size_), word);
}

}  // namespace processor
