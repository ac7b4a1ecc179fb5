// SPDX-License-Identifier: Apache-2.0
// What is known of a function for each set of constant arguments, found from what it calls.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "tools/timing/flow.hpp"
#include "tools/timing/problem.hpp"
#include "tools/timing/state.hpp"

namespace timing {

// A function of which nothing but its address is known. The code that saves registers is called by
// another register than all else.
Entry entry_of(const Program& program, Address function);

// What is known where a function begins: constant arguments, and the registers that never change.
State state_in_callee(const Program& program, const State& at_call);

// A function and its constant arguments.
struct Context {
  Entry entry;
  std::array<std::pair<bool, std::uint32_t>, last_argument - first_argument + 1> arguments;
  auto operator<=>(const Context&) const = default;
};

Context context_of(Entry entry, const State& start);

template <class Result>
class CallTree {
 public:
  explicit CallTree(const Program& program) : program_(program) {}

  // Of `measure(entry, start)`, once for each function and its constant arguments; nothing where it
  // throws Unbounded or the function is under way already.
  template <class Measure>
  std::optional<Result> of(Entry entry, const State& at_call, const Measure& measure) {
    const State start = state_in_callee(program_, at_call);
    const Context context = context_of(entry, start);
    if (const auto found = known_.find(context); found != known_.end()) return found->second;
    if (!under_way_.insert(entry.address).second) {
      add({.place = program_.place_of(entry.address),
           .function = program_.name_of(entry.address),
           .what = "the function calls itself, or others that call it",
           .remedy = "write it as a loop"});
      return std::nullopt;
    }
    std::optional<Result> result;
    try {
      result = measure(entry, start);
    } catch (const Unbounded& error) {
      add(error.problem());
    }
    under_way_.erase(entry.address);
    known_[context] = result;
    return result;
  }

  const std::set<Problem>& problems() const { return problems_; }
  void add(Problem problem) { problems_.insert(std::move(problem)); }
  void forget_problems() { problems_.clear(); }

 private:
  const Program& program_;
  std::map<Context, std::optional<Result>> known_;
  std::set<Address> under_way_;
  std::set<Problem> problems_;
};

}  // namespace timing
