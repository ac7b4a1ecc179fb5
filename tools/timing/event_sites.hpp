// SPDX-License-Identifier: Apache-2.0
// On which ways of a function events happen that a fact limits.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "tools/timing/flow.hpp"
#include "tools/timing/network.hpp"
#include "tools/timing/program.hpp"

namespace timing {

// A set of the program's facts, by their numbers.
using FactSet = std::uint64_t;

// The numbers of a set, in order.
std::vector<std::size_t> members(FactSet set);

// Throws std::runtime_error for more than a set holds.
std::vector<Fact> facts_of(const Program& program);

// A marker has no instruction of its own but the address of the next one, so a jump to that address
// may lead to behind it. Therefore
// - an event counts on a way that surely passes it: from the instruction before it in the image, or
//   the only way there;
// - a run begins on every way to the address on which it is not surely under way.
// Both can only make a bound larger. A run is under way at a place if all ways there have begun it.
class EventSites {
 public:
  struct Passed {
    std::vector<std::size_t> events, begins;
  };

  // `ways`: those that may be taken; `at_entry`: facts whose runs are under way when the function
  // is called.
  EventSites(const Program& program, const std::vector<Fact>& facts, const Flow& flow,
             const std::vector<std::vector<Way>>& ways, FactSet at_entry);

  Passed on(std::size_t node, const Way& way) const;
  Passed on_entry() const;
  // At the instruction, or in what it calls.
  FactSet under_way(std::size_t node) const { return after_[node]; }
  // Of all events of the function itself, those that these facts would limit.
  FactSet happening() const { return happening_; }

 private:
  Passed pass(std::size_t to, FactSet before, bool is_sure) const;
  FactSet after_markers(std::size_t node, FactSet before) const;
  bool surely_passes(std::size_t node, const Way& way) const;

  const std::vector<Fact>& facts_;
  const Flow& flow_;
  FactSet at_entry_;
  std::vector<std::vector<EventMarker>> markers_;  // of each node, as they lie in the image
  std::vector<std::size_t> ways_in_;  // that the code has, taken or not
  std::vector<bool> behind_what_never_returns_;
  std::vector<FactSet> after_;
  FactSet happening_ = 0;
};

}  // namespace timing
