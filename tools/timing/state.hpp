// SPDX-License-Identifier: Apache-2.0
// What is known of the registers at a place: constants, and distances between other values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "sim/processor/decoder.hpp"
#include "tools/timing/program.hpp"

namespace timing {

// `offset` on from a base: 0, a register at the function's start, or what one instruction has
// written or one place has joined last.
struct Value {
  static constexpr std::uint64_t constant = 0, unknown = ~std::uint64_t{0};

  std::uint64_t base = unknown;
  std::uint32_t offset = 0;

  bool is_constant() const { return base == constant; }
  bool is_known() const { return base != unknown; }
  bool operator==(const Value&) const = default;
};

constexpr unsigned return_register = 1, stack_pointer = 2, global_pointer = 3, second_link = 5,
                   first_argument = 10, last_argument = 17;

struct State {
  std::array<Value, processor::no_register + 1> registers;

  // Every register has the value that it has at the function's start.
  static State at_start();
  void set(unsigned index, Value value) {
    if (index != 0 && index < processor::no_register) registers[index] = value;
  }
  bool operator==(const State&) const = default;
};

// What the instruction does, a call without its callee.
void execute(const Program& program, Address address, const processor::Instruction& instruction,
             State& state);

// What a function may do to the registers of its caller, by the calling convention.
void forget_what_calls_change(Address call, State& state);

// Whether the branch is taken, where that is known.
std::optional<bool> decide(const processor::Instruction& branch, const State& state);

// What is known where several ways meet at a place.
void join_at(Address place, State& known, const State& arriving);

}  // namespace timing
