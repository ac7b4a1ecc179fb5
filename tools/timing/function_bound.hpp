// SPDX-License-Identifier: Apache-2.0
// The longest path through one function whose loops have bounds, from some registers.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "tools/timing/analysis.hpp"
#include "tools/timing/loops.hpp"

namespace timing {

class FunctionBound {
 public:
  FunctionBound(Analysis& analysis, const Flow& flow, Entry entry, const State& start);
  // Nothing where problems were added to the analysis.
  std::optional<Clocks> longest();

 private:
  // From the start of a loop, or of the function: to its start again, out of it, to a path's end.
  struct Level {
    std::optional<Clocks> again, end;
    std::map<std::size_t, Clocks> exits;
  };

  Level level(std::size_t start, const Loop* loop);
  // All its rounds.
  Level rounds(const Loop& loop);
  std::optional<Clocks> most_rounds(const Loop& loop);
  std::optional<Clocks> counted_rounds(const Loop& loop) const;
  std::optional<Clocks> counted_rounds(const Loop& loop, State state) const;
  Clocks cost(std::size_t node, const Way* way);
  Clocks called(std::size_t node);
  bool on_bus(std::size_t node) const;
  bool only_sleeps(const Loop& loop) const;
  void add_problem(Address address, std::string what, std::string remedy);

  Analysis& analysis_;
  const Flow& flow_;
  Entry entry_;
  State start_;
  Reached reached_;
  std::vector<std::vector<Way>> ways_;
  Graph graph_;  // the same without branches
  Loops loops_;
  std::map<std::size_t, Level> levels_;  // of loops, by their header
  bool is_bounded_ = true;
};

}  // namespace timing
