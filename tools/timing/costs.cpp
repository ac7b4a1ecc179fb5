// SPDX-License-Identifier: Apache-2.0
// The rows of the table of times for each operation.
#include "tools/timing/costs.hpp"

#include "sim/processor/timing_table.hpp"

namespace timing {

namespace {

using processor::Instruction;
using processor::Operation;

bool is_late(Operation operation) {
  return is_load(operation) || operation == Operation::csr ||
         operation == Operation::manipulate_late ||
         (operation >= Operation::multiply && operation <= Operation::multiply_high_unsigned);
}

}  // namespace

Costs::Costs(const processor::TimingTable& table)
    : simple(table.at("arithmetic and logic")),
      multiplication(table.at("multiplication")),
      bit_manipulation(table.at("bit manipulation")),
      division(table.at("division")),
      load(table.at("load from memory")),
      store(table.at("store to memory")),
      bus_load(table.at("load from a peripheral")),
      bus_store(table.at("store to a peripheral")),
      not_taken(table.at("branch predicted not taken, not taken")),
      taken(table.at("branch predicted not taken, taken")),
      predicted_not_taken(table.at("branch predicted taken, not taken")),
      predicted_taken(table.at("branch predicted taken, taken")),
      jump(table.at("jump")),
      jump_register(table.at("jump to a register")),
      fence_i(table.at("fence.i")),
      csr(table.at("CSR instruction")),
      trap_return(table.at("mret")),
      wait(table.at("wfi")),
      hazard(table.at("load-use hazard")) {}

unsigned Costs::of(const Instruction& instruction, bool is_taken, bool on_bus) const {
  const Operation operation = instruction.operation;
  if (is_load(operation)) return on_bus ? bus_load : load;
  if (is_store(operation)) return on_bus ? bus_store : store;
  if (is_branch(operation)) {
    const bool is_predicted = instruction.behind_taken < instruction.behind_not_taken;
    if (is_predicted) return is_taken ? predicted_taken : predicted_not_taken;
    return is_taken ? taken : not_taken;
  }
  switch (operation) {
    case Operation::multiply:
    case Operation::multiply_high:
    case Operation::multiply_high_mixed:
    case Operation::multiply_high_unsigned:
      return multiplication;
    case Operation::manipulate_late:
      return bit_manipulation;
    case Operation::divide:
      return division;
    case Operation::jump:
      return jump;
    case Operation::jump_register:
      return jump_register;
    case Operation::fence_i:
      return fence_i;
    case Operation::csr:
      return csr;
    case Operation::trap_return:
      return trap_return;
    case Operation::wait_for_interrupt:
      return wait;
    default:
      return simple;
  }
}

unsigned Costs::between(const Instruction& instruction, const Instruction& next) const {
  const std::uint8_t late =
      is_late(instruction.operation) ? instruction.destination : processor::no_register;
  return next.first == late || next.second == late ? hazard : 0;
}

}  // namespace timing
