// SPDX-License-Identifier: Apache-2.0
// One bound for each function and each set of constant arguments.
#include "tools/timing/analysis.hpp"

#include "tools/timing/function_bound.hpp"

namespace timing {

Analysis::Analysis(const Program& program, const Costs& costs, bool has_zbb)
    : program_(program), costs_(costs), flows_(program, has_zbb), reach_(program, flows_) {}

std::optional<Clocks> Analysis::bound(Address function) {
  // Called by another register than all else.
  const bool saves = program_.name_of(function).starts_with("__riscv_save");
  return bound({.address = function, .link = saves ? second_link : return_register},
               State::at_start());
}

std::optional<Clocks> Analysis::bound(Entry entry, const State& at_call) {
  Context context{.entry = entry, .arguments = {}};
  State start = State::at_start();
  for (unsigned index = first_argument; index <= last_argument; ++index) {
    const Value value = at_call.registers[index];
    if (!value.is_constant()) continue;
    start.set(index, value);
    context.arguments[index - first_argument] = {true, value.offset};
  }
  if (const auto pointer = program_.addresses.find("__global_pointer$");
      pointer != program_.addresses.end()) {
    start.set(global_pointer, {.base = Value::constant, .offset = pointer->second});
  }
  start.registers[0] = {.base = Value::constant, .offset = 0};
  if (const auto found = known_.find(context); found != known_.end()) return found->second;
  std::optional<Clocks> clocks;
  if (!under_way_.insert(entry.address).second) {
    problems_.insert({.place = program_.place_of(entry.address),
                      .function = program_.name_of(entry.address),
                      .what = "the function calls itself, or others that call it",
                      .remedy = "write it as a loop"});
    return std::nullopt;
  }
  try {
    clocks = FunctionBound(*this, flows_.of(entry), entry, start).longest();
  } catch (const Unbounded& error) {
    problems_.insert(error.problem());
  }
  under_way_.erase(entry.address);
  known_[context] = clocks;
  return clocks;
}

}  // namespace timing
