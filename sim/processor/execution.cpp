// SPDX-License-Identifier: Apache-2.0
// One instruction after the other, each in its clock.
#include <cstring>
#include <limits>

#include "sim/processor/instructions.hpp"
#include "sim/processor/processor_model.hpp"
#include "sim/processor/times.hpp"

namespace processor {

namespace {

constexpr std::uint32_t fetch_access = 1, illegal_instruction = 2, breakpoint_cause = 3,
                        load_misaligned = 4, store_misaligned = 6, environment_call_cause = 11;

std::int32_t as_signed(std::uint32_t value) { return static_cast<std::int32_t>(value); }

std::uint32_t upper(std::uint64_t product) { return static_cast<std::uint32_t>(product >> 32); }
std::uint64_t wide(std::int32_t value) { return static_cast<std::uint64_t>(std::int64_t{value}); }

std::uint32_t quotient_or_remainder(std::uint32_t word, std::uint32_t a, std::uint32_t b) {
  const unsigned which = word >> 12 & 3;
  const bool remainder = (which & 2) != 0;
  if (b == 0) return remainder ? a : ~std::uint32_t{0};
  if ((which & 1) != 0) return remainder ? a % b : a / b;
  if (as_signed(a) == std::numeric_limits<std::int32_t>::min() && as_signed(b) == -1) {
    return remainder ? 0 : a;
  }
  return static_cast<std::uint32_t>(remainder ? as_signed(a) % as_signed(b)
                                              : as_signed(a) / as_signed(b));
}

}  // namespace

template <class Value>
bool ProcessorModel::store(std::uint32_t place, std::uint32_t value) {
  if (stored_ == most_stores) {
    full_ = true;
    return false;
  }
  const std::uint32_t word_place = place & ~3U;
  stores_[stored_++] = {word_place, word_at(word_place)};
  const auto stored = static_cast<Value>(value);
  std::memcpy(&memory_[place], &stored, sizeof stored);
  if (holds_code_[place >> code_block_shift] != 0) forget_code(place, sizeof stored);
  return true;
}

template <bool single>
bool ProcessorModel::execute(Clock limit) {
  std::uint32_t* const r = state_.registers.data();
  std::uint32_t pc = state_.program_counter;
  Clock begins = state_.begins;
  std::uint8_t late = state_.late_register;
  std::uint64_t instructions = state_.instructions;
  const auto save = [&] {
    state_.program_counter = pc;
    state_.begins = begins;
    state_.late_register = late;
    state_.instructions = instructions;
  };
  const auto load = [&]<class Value>(std::uint32_t place) {
    Value value{};
    std::memcpy(&value, &memory_[place], sizeof value);
    return static_cast<std::uint32_t>(value);
  };

  for (;;) {
    const std::uint32_t fetched = pc - memory_start;
    if (fetched >= size_) {
      if (begins > limit) break;
      save();
      trap(fetch_access, pc, begins);
      return true;
    }
    const Instruction& next = decoded_[fetched >> 1];
    const bool waits = next.first == late || next.second == late;
    const Clock clock = begins + (waits ? times::late_result_used : 0);
    if (clock > limit && next.operation > Operation::wait_for_interrupt) break;
    const std::uint32_t a = r[next.first], b = r[next.second], immediate = next.immediate;
    std::uint32_t& result = r[next.destination];

    const auto branch = [&](bool taken) {
      pc = taken ? immediate : pc + next.bytes;
      begins = clock + 1 + (taken ? next.behind_taken : next.behind_not_taken);
    };
    // True where the instruction has been executed.
    const auto load_to_register = [&]<class Value>() {
      const std::uint32_t place = a + immediate - memory_start;
      if (place >= size_ || place % sizeof(Value) != 0) return false;
      result = load.template operator()<Value>(place);
      pc += next.bytes;
      begins = clock + 1;
      late = next.destination;
      ++instructions;
      return true;
    };
    const auto store_from_register = [&]<class Value>() {
      const std::uint32_t place = a + immediate - memory_start;
      if (place >= size_ || place % sizeof(Value) != 0) return false;
      if (!store<Value>(place, b)) return false;
      pc += next.bytes;
      begins = clock + 1;
      late = no_register;
      ++instructions;
      return true;
    };
    // What a load or store does that is not one of the memory.
    const auto other_access = [&](std::uint32_t bytes, std::uint32_t cause) {
      save();
      if (full_) return false;
      const std::uint32_t address = a + immediate;
      if (address % bytes != 0) {
        trap(cause, address, clock);
      } else {
        begin_access(next, address, clock);
      }
      return true;
    };

#define LOAD(operation, Type)                                \
  case Operation::operation:                                 \
    if (load_to_register.template operator()<Type>()) break; \
    return other_access(sizeof(Type), load_misaligned);
#define STORE(operation, Type)                                  \
  case Operation::operation:                                    \
    if (store_from_register.template operator()<Type>()) break; \
    return other_access(sizeof(Type), store_misaligned);
#define BRANCH(operation, condition) \
  case Operation::operation:         \
    branch(condition);               \
    late = no_register;              \
    ++instructions;                  \
    break;
// One clock, and the result at once; or late.
#define RESULT(operation, value) \
  case Operation::operation:     \
    result = (value);            \
    pc += next.bytes;            \
    begins = clock + 1;          \
    late = no_register;          \
    ++instructions;              \
    break;
#define LATE_RESULT(operation, value) \
  case Operation::operation:          \
    result = (value);                 \
    pc += next.bytes;                 \
    begins = clock + 1;               \
    late = next.destination;          \
    ++instructions;                   \
    break;

    switch (next.operation) {
      case Operation::undecoded:
        decoded_at(fetched);
        continue;
        LOAD(load_byte, std::int8_t)
        LOAD(load_half, std::int16_t)
        LOAD(load_word, std::uint32_t)
        LOAD(load_unsigned_byte, std::uint8_t)
        LOAD(load_unsigned_half, std::uint16_t)
        STORE(store_byte, std::uint8_t)
        STORE(store_half, std::uint16_t)
        STORE(store_word, std::uint32_t)
        BRANCH(branch_equal, a == b)
        BRANCH(branch_not_equal, a != b)
        BRANCH(branch_less, as_signed(a) < as_signed(b))
        BRANCH(branch_not_less, as_signed(a) >= as_signed(b))
        BRANCH(branch_below, a < b)
        BRANCH(branch_not_below, a >= b)
        RESULT(constant, immediate)
        RESULT(add_immediate, a + immediate)
        RESULT(less_immediate, as_signed(a) < as_signed(immediate) ? 1 : 0)
        RESULT(below_immediate, a < immediate ? 1 : 0)
        RESULT(xor_immediate, a ^ immediate)
        RESULT(or_immediate, a | immediate)
        RESULT(and_immediate, a & immediate)
        RESULT(shift_left_immediate, a << immediate)
        RESULT(shift_right_immediate, a >> immediate)
        RESULT(shift_arithmetic_immediate, static_cast<std::uint32_t>(as_signed(a) >> immediate))
        RESULT(add, a + b)
        RESULT(subtract, a - b)
        RESULT(shift_left, a << (b & 31))
        RESULT(less, as_signed(a) < as_signed(b) ? 1 : 0)
        RESULT(below, a < b ? 1 : 0)
        RESULT(exclusive_or, a ^ b)
        RESULT(shift_right, a >> (b & 31))
        RESULT(shift_arithmetic, static_cast<std::uint32_t>(as_signed(a) >> (b & 31)))
        RESULT(inclusive_or, a | b)
        RESULT(conjunction, a & b)
        RESULT(manipulate, *bit_manipulation(next.word, a, b))
        RESULT(fence, r[no_register])
        LATE_RESULT(manipulate_late, *bit_manipulation(next.word, a, b))
        LATE_RESULT(multiply, a * b)
        LATE_RESULT(multiply_high, upper(wide(as_signed(a)) * wide(as_signed(b))))
        LATE_RESULT(multiply_high_mixed, upper(wide(as_signed(a)) * b))
        LATE_RESULT(multiply_high_unsigned, upper(std::uint64_t{a} * b))
      case Operation::divide:
        if (clock + times::division > limit) {
          save();
          return false;
        }
        result = quotient_or_remainder(next.word, a, b);
        pc += next.bytes;
        begins = clock + times::division + 1;
        late = no_register;
        ++instructions;
        break;
      case Operation::jump:
        result = pc + next.bytes;
        pc = immediate;
        begins = clock + 1 + times::jump;
        late = no_register;
        ++instructions;
        break;
      case Operation::jump_register:
        result = pc + next.bytes;
        pc = (a + immediate) & ~1U;
        begins = clock + 1 + times::jump_register;
        late = no_register;
        ++instructions;
        break;
      case Operation::fence_i:
        pc += next.bytes;
        begins = clock + 1 + times::fence_i;
        late = no_register;
        ++instructions;
        break;
      case Operation::csr:
        save();
        switch (execute_csr(next, clock)) {
          case CsrResult::too_early:
            return false;
          case CsrResult::illegal:
            trap(illegal_instruction, next.word, clock);
            return true;
          case CsrResult::done:
            return true;
        }
        break;
      case Operation::trap_return:
        pc = state_.exception_address;
        begins = clock + 1 + times::trap_return;
        late = no_register;
        ++instructions;
        save();
        state_.interrupt_enable = state_.previous_interrupt_enable;
        state_.previous_interrupt_enable = true;
        state_.open_from = clock + times::interrupt_after_return;
        return true;
      case Operation::wait_for_interrupt:
        save();
        // The output that shows the sleep is there one edge earlier.
        state_.asleep = begins <= limit + 1;
        return state_.asleep;
      case Operation::environment_call:
        save();
        trap(environment_call_cause, 0, clock);
        return true;
      case Operation::breakpoint:
        save();
        trap(breakpoint_cause, pc, clock);
        return true;
      case Operation::fetch_fault:
        save();
        trap(fetch_access, pc + 2, clock);
        return true;
      case Operation::illegal:
        save();
        trap(illegal_instruction, next.word, clock);
        return true;
    }
    if constexpr (single) {
      save();
      return true;
    }
  }
#undef LOAD
#undef STORE
#undef BRANCH
#undef RESULT
#undef LATE_RESULT
  save();
  return false;
}

template bool ProcessorModel::execute<true>(Clock limit);
template bool ProcessorModel::execute<false>(Clock limit);

}  // namespace processor
