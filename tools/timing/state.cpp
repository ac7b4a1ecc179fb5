// SPDX-License-Identifier: Apache-2.0
// Instructions on values that are partly known.
#include "tools/timing/state.hpp"

#include <algorithm>

namespace timing {

namespace {

using processor::Instruction;
using processor::Operation;

constexpr std::uint64_t joined_base = std::uint64_t{1} << 62;
constexpr unsigned register_bits = 6;

std::uint64_t joined(Address place, unsigned index) {
  return joined_base | std::uint64_t{place} << register_bits | index;
}

bool is_joined_at(Address place, std::uint64_t base) {
  return base != Value::unknown && (base & joined_base) != 0 &&
         (base ^ joined(place, 0)) >> register_bits == 0;
}

std::int32_t as_signed(std::uint32_t value) { return static_cast<std::int32_t>(value); }

Value number(std::uint32_t value) { return {.base = Value::constant, .offset = value}; }

std::optional<std::uint32_t> of_numbers(Operation operation, std::uint32_t a, std::uint32_t b) {
  using enum Operation;
  switch (operation) {
    case add_immediate:
    case add:
      return a + b;
    case subtract:
      return a - b;
    case less_immediate:
    case less:
      return as_signed(a) < as_signed(b) ? 1 : 0;
    case below_immediate:
    case below:
      return a < b ? 1 : 0;
    case xor_immediate:
    case exclusive_or:
      return a ^ b;
    case or_immediate:
    case inclusive_or:
      return a | b;
    case and_immediate:
    case conjunction:
      return a & b;
    case shift_left_immediate:
    case shift_left:
      return a << (b & 31);
    case shift_right_immediate:
    case shift_right:
      return a >> (b & 31);
    case shift_arithmetic_immediate:
    case shift_arithmetic:
      return static_cast<std::uint32_t>(as_signed(a) >> (b & 31));
    case multiply:
      return a * b;
    default:
      return std::nullopt;
  }
}

Value of_values(Operation operation, Value a, Value b) {
  if (a.is_constant() && b.is_constant()) {
    const auto result = of_numbers(operation, a.offset, b.offset);
    return result ? number(*result) : Value{};
  }
  const bool adds = operation == Operation::add_immediate || operation == Operation::add;
  if (adds && a.is_known() && b.is_constant()) return {a.base, a.offset + b.offset};
  if (adds && a.is_constant() && b.is_known()) return {b.base, a.offset + b.offset};
  if (operation == Operation::subtract && a.is_known()) {
    if (b.is_constant()) return {a.base, a.offset - b.offset};
    if (a.base == b.base) return number(a.offset - b.offset);
  }
  // The calling convention aligns the stack to 16 bytes.
  const bool masks = operation == Operation::and_immediate && b.offset < 16;
  if (masks && a.base == stack_pointer) return number(a.offset & b.offset);
  return {};
}

std::optional<std::uint32_t> loaded(const Program& program, const Instruction& load, Value place) {
  if (!place.is_constant()) return std::nullopt;
  const Address address = place.offset + load.immediate;
  switch (load.operation) {
    case Operation::load_word:
      return program.constant_at(address, 4);
    case Operation::load_unsigned_byte:
      return program.constant_at(address, 1);
    case Operation::load_unsigned_half:
      return program.constant_at(address, 2);
    default:
      return std::nullopt;
  }
}

Value result_of(const Program& program, Address address, const Instruction& instruction,
                const State& state) {
  const Operation operation = instruction.operation;
  const Value first = state.registers[instruction.first];
  if (operation == Operation::constant) return number(instruction.immediate);
  if (operation == Operation::jump || operation == Operation::jump_register) {
    return number(address + instruction.bytes);
  }
  if (is_load(operation)) {
    const auto value = loaded(program, instruction, first);
    return value ? number(*value) : Value{};
  }
  const bool has_immediate =
      operation >= Operation::add_immediate && operation <= Operation::shift_arithmetic_immediate;
  const Value second =
      has_immediate ? number(instruction.immediate) : state.registers[instruction.second];
  return of_values(operation, first, second);
}

}  // namespace

State State::at_start() {
  State state;
  for (unsigned index = 0; index < processor::no_register; ++index) {
    state.registers[index] = {.base = index, .offset = 0};
  }
  return state;
}

void execute(const Program& program, Address address, const Instruction& instruction,
             State& state) {
  const unsigned destination = instruction.destination;
  if (destination == processor::no_register) return;
  Value result = result_of(program, address, instruction, state);
  if (!result.is_known()) {
    // A new value of this instruction: what else is based on its last one, is not on this.
    for (Value& value : state.registers) {
      if (value.base == address) value = {};
    }
    result = {.base = address, .offset = 0};
  }
  state.set(destination, result);
}

void forget_what_calls_change(Address call, State& state) {
  const auto changes = [](unsigned index) {
    return index == return_register || (index >= 5 && index <= 7) ||
           (index >= first_argument && index <= last_argument) || index >= 28;
  };
  for (unsigned index = 0; index <= processor::no_register; ++index) {
    if (changes(index) || state.registers[index].base == call) state.registers[index] = {};
  }
  state.set(first_argument, {.base = call, .offset = 0});
}

std::optional<bool> decide(const Instruction& branch, const State& state) {
  using enum Operation;
  const Value a = state.registers[branch.first], b = state.registers[branch.second];
  if (!a.is_known() || a.base != b.base) return std::nullopt;
  if (branch.operation == branch_equal) return a.offset == b.offset;
  if (branch.operation == branch_not_equal) return a.offset != b.offset;
  if (!a.is_constant() && a.offset != b.offset) return std::nullopt;
  switch (branch.operation) {
    case branch_less:
      return as_signed(a.offset) < as_signed(b.offset);
    case branch_not_less:
      return as_signed(a.offset) >= as_signed(b.offset);
    case branch_below:
      return a.offset < b.offset;
    case branch_not_below:
      return a.offset >= b.offset;
    default:
      return std::nullopt;
  }
}

// A register that differs gets a base of its own, which stands for its value at the latest arrival.
// So no value may arrive that is based on an earlier one.
void join_at(Address place, State& known, const State& arriving) {
  for (unsigned index = 1; index < processor::no_register; ++index) {
    Value& value = known.registers[index];
    const Value other = arriving.registers[index];
    const bool is_stale = is_joined_at(place, value.base) || is_joined_at(place, other.base);
    if (value != other || is_stale) value = {.base = joined(place, index), .offset = 0};
  }
}

}  // namespace timing
