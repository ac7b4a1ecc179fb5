// SPDX-License-Identifier: Apache-2.0
// An instruction as the model executes it.
#pragma once

#include <cstdint>

namespace processor {

enum class Operation : std::uint8_t {
  undecoded,
  wait_for_interrupt,  // these two do something before their clock
  illegal,
  fetch_fault,  // its second half lies outside the memory
  constant,  // lui, auipc
  jump,
  jump_register,
  branch_equal,
  branch_not_equal,
  branch_less,
  branch_not_less,
  branch_below,
  branch_not_below,
  load_byte,
  load_half,
  load_word,
  load_unsigned_byte,
  load_unsigned_half,
  store_byte,
  store_half,
  store_word,
  add_immediate,
  less_immediate,
  below_immediate,
  xor_immediate,
  or_immediate,
  and_immediate,
  shift_left_immediate,
  shift_right_immediate,
  shift_arithmetic_immediate,
  add,
  subtract,
  shift_left,
  less,
  below,
  exclusive_or,
  shift_right,
  shift_arithmetic,
  inclusive_or,
  conjunction,
  multiply,
  multiply_high,
  multiply_high_mixed,
  multiply_high_unsigned,
  divide,  // with the remainders: funct3 of the word says which
  manipulate,  // Zbb by the alu
  manipulate_late,  // Zbb with a late result
  fence,
  fence_i,
  csr,
  environment_call,
  breakpoint,
  trap_return,
};

constexpr bool is_branch(Operation operation) {
  return operation >= Operation::branch_equal && operation <= Operation::branch_not_below;
}
constexpr bool is_load(Operation operation) {
  return operation >= Operation::load_byte && operation <= Operation::load_unsigned_half;
}
constexpr bool is_store(Operation operation) {
  return operation >= Operation::store_byte && operation <= Operation::store_word;
}

// Replaces x0 as a destination, and means "no register" in comparisons.
inline constexpr std::uint8_t no_register = 32;

struct Instruction {
  Operation operation = Operation::undecoded;
  std::uint8_t destination = no_register;
  std::uint8_t first = 0;  // registers that it reads; x0 where it reads none
  std::uint8_t second = 0;
  // Of jumps and branches the target, of lui and auipc the result, of CSR instructions the number.
  std::uint32_t immediate = 0;
  std::uint32_t word = 0;  // as it lies in memory: of a compressed one the upper half is 0
  std::uint8_t bytes = 4;
  // Of branches: clocks in which nothing executes after them.
  std::uint8_t behind_taken = 0;
  std::uint8_t behind_not_taken = 0;
};

// `word` at `address`; of a compressed instruction only its lower half counts.
Instruction decode(std::uint32_t word, std::uint32_t address, bool has_zbb);

}  // namespace processor
