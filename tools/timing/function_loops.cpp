// SPDX-License-Identifier: Apache-2.0
// How often the loops of a function go round.
#include <algorithm>

#include "tools/timing/function_network.hpp"
#include "tools/timing/markers.hpp"

namespace timing {

namespace {

using processor::Operation;

}  // namespace

// Each way in by itself, since one alone may bring a number that is known.
std::optional<Clocks> FunctionNetwork::counted_rounds(const Loop& loop) const {
  std::optional<Clocks> most = 0;
  const auto arrive = [&](const State& arriving) {
    State state = arriving;
    join_at(flow_.nodes[loop.header].address, state, arriving);
    const auto rounds = most ? counted_rounds(loop, state) : std::nullopt;
    most = rounds ? std::max(most, rounds) : std::nullopt;
  };
  if (loop.header == 0) arrive(start_);
  for (std::size_t node = 0; node < flow_.nodes.size(); ++node) {
    if (loop.nodes[node]) continue;
    for (const Way& way : ways_[node]) {
      if (way.to == loop.header) {
        arrive(analysis_.reach_.after(flow_.nodes[node], *reached_.before[node]));
      }
    }
  }
  return most;
}

std::optional<Clocks> FunctionNetwork::counted_rounds(const Loop& loop, State state) const {
  constexpr Clocks most_rounds = 20'000;
  constexpr std::size_t most_visits = 200'000;
  std::size_t visits = 0;
  for (Clocks rounds = 0; rounds <= most_rounds && visits <= most_visits; ++rounds) {
    const Reached reached = analysis_.reach_.once(flow_, loop.header, state, loop.nodes);
    if (!reached.back) return rounds;
    // Without a branch that is known nothing counts the rounds.
    bool knows = false;
    for (std::size_t node = 0; node < flow_.nodes.size() && !knows; ++node) {
      const auto& before = reached.before[node];
      knows = before && flow_.nodes[node].ways.size() > 1 &&
              decide(flow_.nodes[node].instruction, *before);
    }
    if (!knows) return std::nullopt;
    if (reached.back == state) return std::nullopt;
    state = *reached.back;
    visits += reached.visits;
  }
  return std::nullopt;
}

std::optional<Clocks> FunctionNetwork::most_rounds(const Loop& loop) {
  // What the code itself shows needs no trust in the source.
  if (const auto counted = counted_rounds(loop)) return counted;
  const auto declared = declared_rounds(analysis_.program_.markers, flow_, graph_, loops_, loop);
  if (!declared) {
    add_problem(
        flow_.nodes[loop.header].address, "a loop has no bound",
        "declare LoopBound<N> before it and call next() first in it (units/loop_bound.hpp)");
  }
  return declared;
}

bool FunctionNetwork::only_sleeps(const Loop& loop) const {
  bool sleeps = false;
  for (std::size_t node = 0; node < flow_.nodes.size(); ++node) {
    if (!loop.nodes[node]) continue;
    const Operation operation = flow_.nodes[node].instruction.operation;
    if (operation == Operation::wait_for_interrupt) {
      sleeps = true;
    } else if (operation != Operation::jump) {
      return false;
    }
  }
  return sleeps;
}

bool FunctionNetwork::has_end(const Loop& loop) const {
  for (const std::size_t node : loops_.order) {
    if (!loop.nodes[node]) continue;
    if (ways_[node].empty()) return true;
    for (const Way& way : ways_[node]) {
      if (!loop.nodes[way.to]) return true;
    }
  }
  return false;
}

void FunctionNetwork::add_loop(const Loop& loop) {
  if (has_end(loop)) {
    network_.loops.push_back(
        {.header = loop.header, .nodes = loop.nodes, .most = most_rounds(loop).value_or(0)});
  } else if (only_sleeps(loop)) {
    // The way ends there.
    std::erase_if(network_.arcs, [&](const Arc& arc) { return loop.nodes[arc.from]; });
    Arc end;
    end.from = loop.header;
    end.to = network_.end;
    network_.arcs.push_back(std::move(end));
  } else {
    add_problem(flow_.nodes[loop.header].address, "a loop has no end",
                "ask for the bound of what it calls");
  }
}

}  // namespace timing
