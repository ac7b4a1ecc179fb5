// SPDX-License-Identifier: Apache-2.0
// Where a function begins.
#include "tools/timing/call_tree.hpp"

namespace timing {

Entry entry_of(const Program& program, Address function) {
  const bool saves = program.name_of(function).starts_with("__riscv_save");
  return {.address = function, .link = saves ? second_link : return_register};
}

State state_in_callee(const Program& program, const State& at_call) {
  State start = State::at_start();
  for (unsigned index = first_argument; index <= last_argument; ++index) {
    const Value value = at_call.registers[index];
    if (value.is_constant()) start.set(index, value);
  }
  if (const auto pointer = program.addresses.find("__global_pointer$");
      pointer != program.addresses.end()) {
    start.set(global_pointer, {.base = Value::constant, .offset = pointer->second});
  }
  start.registers[0] = {.base = Value::constant, .offset = 0};
  return start;
}

Context context_of(Entry entry, const State& start) {
  Context context{.entry = entry, .arguments = {}};
  for (unsigned index = first_argument; index <= last_argument; ++index) {
    const Value value = start.registers[index];
    if (value.is_constant()) context.arguments[index - first_argument] = {true, value.offset};
  }
  return context;
}

}  // namespace timing
