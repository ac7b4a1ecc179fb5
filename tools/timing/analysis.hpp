// SPDX-License-Identifier: Apache-2.0
// The longest time that a function takes, with all that it calls.
#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include "tools/timing/call_tree.hpp"
#include "tools/timing/costs.hpp"
#include "tools/timing/flow.hpp"
#include "tools/timing/reach.hpp"

namespace timing {

using Clocks = std::uint64_t;

class FunctionBound;

class Analysis {
 public:
  Analysis(const Program& program, const Costs& costs, bool has_zbb = false);

  // From the clock of its first instruction to that of the first one behind its end, without
  // sleep; nothing where there are problems. Nothing is known of its arguments.
  std::optional<Clocks> bound(Address function);
  const std::set<Problem>& problems() const { return tree_.problems(); }
  void forget_problems() { tree_.forget_problems(); }

 private:
  friend class FunctionBound;

  std::optional<Clocks> bound(Entry entry, const State& at_call);

  const Program& program_;
  Costs costs_;
  Flows flows_;
  Reach reach_;
  CallTree<Clocks> tree_;
};

}  // namespace timing
