// SPDX-License-Identifier: Apache-2.0
// The longest time that a function takes, with all that it calls.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "tools/timing/call_tree.hpp"
#include "tools/timing/costs.hpp"
#include "tools/timing/event_sites.hpp"
#include "tools/timing/flow.hpp"
#include "tools/timing/reach.hpp"

namespace timing {

class FunctionNetwork;

class Analysis {
 public:
  Analysis(const Program& program, const Costs& costs, bool has_zbb = false);

  // From the clock of its first instruction to that of the first one behind its end, without
  // sleep; nothing where there are problems. Nothing is known of its arguments.
  std::optional<Clocks> bound(Address function);
  // One round of the loop around all others in it, of main's the pass over all tasks.
  std::optional<Clocks> round(Address function);
  // The ways in a function from some places to the next of others.
  std::optional<Clocks> span(Address function, const std::set<Address>& begins,
                             const std::set<Address>& ends);
  // Where that loop begins.
  Address round_start(Address function);
  // What the bound is computed from; nothing where there are problems.
  std::optional<Networks> networks(Address function);
  const std::set<Problem>& problems() const { return tree_.problems(); }
  void add(Problem problem) { tree_.add(std::move(problem)); }
  void forget_problems() { tree_.forget_problems(); }

 private:
  friend class FunctionNetwork;

  struct Bound {
    Clocks clocks{};
    FactSet happening{};  // facts that would limit events of the function or of what it calls
  };
  class Linker;
  using Link = std::function<std::size_t(Entry, const State&, FactSet)>;
  // Of the function asked for: all of it, or some of its ways.
  using Part = std::function<std::optional<Network>(FunctionNetwork&, const Link&)>;

  std::optional<Clocks> part_of(Entry entry, const Part& part);
  std::optional<Bound> bound(Entry entry, const State& at_call);
  std::optional<Bound> measure(Entry entry, const State& start, const Part& part);

  const Program& program_;
  Costs costs_;
  Flows flows_;
  Reach reach_;
  std::vector<Fact> facts_;
  CallTree<Bound> tree_;
};

}  // namespace timing
