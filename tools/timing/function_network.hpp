// SPDX-License-Identifier: Apache-2.0
// The ways through one function from some registers on, with their clocks and bounds of rounds.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "tools/timing/analysis.hpp"
#include "tools/timing/event_sites.hpp"
#include "tools/timing/loops.hpp"
#include "tools/timing/network.hpp"

namespace timing {

class FunctionNetwork {
 public:
  // A called function, from registers on, while runs of some facts are under way: the number of
  // its network.
  using Link = std::function<std::size_t(Entry, const State&, FactSet)>;

  // `under_way`: facts that limit what the function's caller does in it.
  FunctionNetwork(Analysis& analysis, const Flow& flow, Entry entry, const State& start,
                  FactSet under_way);
  // A call counts as the bound of what is called; where that has events that a fact limits, it is
  // linked. Nothing where problems were added to the analysis.
  std::optional<Network> network(const Link& link);
  // The same of one round of the loop around all others, from its start to its start again; ways
  // out of it do not count.
  std::optional<Network> round(const Link& link);
  // The same of the ways from some places to the next of others.
  std::optional<Network> span(const Link& link, const std::set<Address>& begins,
                              const std::set<Address>& ends);
  // Where that loop begins; the function's start if there is none.
  Address round_start() const {
    return flow_.nodes[loops_.loops.empty() ? 0 : loops_.loops.back().header].address;
  }
  // Facts that would limit events of the function or of what it calls; known after network().
  FactSet happening() const { return happening_; }

 private:
  // What is passed in place of an instruction: each of the functions that a call may reach.
  struct Passage {
    Clocks clocks{};
    std::optional<std::size_t> linked;
  };

  std::vector<Passage> called(std::size_t node, const Link& link);
  bool has_one_entry();
  std::vector<std::size_t> nodes_at(const std::set<Address>& places) const;
  void add_arcs(std::size_t node, const Way* way, const Link& link);
  Clocks cost(std::size_t node, const Way* way) const;
  void add_loop(const Loop& loop);
  std::optional<Clocks> most_rounds(const Loop& loop);
  std::optional<Clocks> counted_rounds(const Loop& loop) const;
  std::optional<Clocks> counted_rounds(const Loop& loop, State state) const;
  bool on_bus(std::size_t node) const;
  bool has_end(const Loop& loop) const;
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
  EventSites events_;
  FactSet happening_;
  Network network_;
  bool is_bounded_ = true;
};

}  // namespace timing
