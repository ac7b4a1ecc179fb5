// SPDX-License-Identifier: Apache-2.0
// One bound for each function and each set of constant arguments.
#include "tools/timing/analysis.hpp"

#include "tools/timing/function_bound.hpp"

namespace timing {

Analysis::Analysis(const Program& program, const Costs& costs, bool has_zbb)
    : program_(program),
      costs_(costs),
      flows_(program, has_zbb),
      reach_(program, flows_),
      tree_(program) {}

std::optional<Clocks> Analysis::bound(Address function) {
  return bound(entry_of(program_, function), State::at_start());
}

std::optional<Clocks> Analysis::bound(Entry entry, const State& at_call) {
  return tree_.of(entry, at_call, [&](Entry begun, const State& start) {
    return FunctionBound(*this, flows_.of(begun), begun, start).longest();
  });
}

}  // namespace timing
