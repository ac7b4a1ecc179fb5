// SPDX-License-Identifier: Apache-2.0
// The longest time that a function takes, with all that it calls.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "tools/timing/costs.hpp"
#include "tools/timing/flow.hpp"
#include "tools/timing/problem.hpp"
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
  const std::set<Problem>& problems() const { return problems_; }
  void forget_problems() { problems_.clear(); }

 private:
  friend class FunctionBound;
  using Arguments = std::array<Value, last_argument - first_argument + 1>;
  struct Context {
    Entry entry;
    std::array<std::pair<bool, std::uint32_t>, std::tuple_size_v<Arguments>> arguments;
    auto operator<=>(const Context&) const = default;
  };

  std::optional<Clocks> bound(Entry entry, const State& at_call);

  const Program& program_;
  Costs costs_;
  Flows flows_;
  Reach reach_;
  std::map<Context, std::optional<Clocks>> known_;
  std::set<Address> under_way_;
  std::set<Problem> problems_;
};

}  // namespace timing
