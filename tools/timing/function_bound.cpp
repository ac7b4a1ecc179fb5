// SPDX-License-Identifier: Apache-2.0
// From inner loops outwards: a loop becomes a node whose ways out cost all its rounds.
#include "tools/timing/function_bound.hpp"

#include "tools/timing/callees.hpp"
#include "tools/timing/markers.hpp"

namespace timing {

namespace {

using processor::Operation;

void raise(std::optional<Clocks>& known, Clocks other) {
  known = std::max(known.value_or(0), other);
}
void raise(std::map<std::size_t, Clocks>& known, std::size_t to, Clocks other) {
  Clocks& value = known[to];
  value = std::max(value, other);
}

}  // namespace

FunctionBound::FunctionBound(Analysis& analysis, const Flow& flow, Entry entry, const State& start)
    : analysis_(analysis),
      flow_(flow),
      entry_(entry),
      start_(start),
      reached_(analysis.reach_.all(flow, start)),
      ways_(flow.nodes.size()),
      graph_(flow.nodes.size()) {
  for (std::size_t i = 0; i < flow.nodes.size(); ++i) {
    if (!reached_.before[i]) continue;
    ways_[i] = Reach::ways(flow.nodes[i], *reached_.before[i]);
    for (const Way& way : ways_[i]) graph_[i].push_back(way.to);
  }
  loops_ = find_loops(graph_);
}

void FunctionBound::add_problem(Address address, std::string what, std::string remedy) {
  is_bounded_ = false;
  analysis_.tree_.add({.place = analysis_.program_.place_of(address),
                       .function = analysis_.program_.name_of(entry_.address),
                       .what = std::move(what),
                       .remedy = std::move(remedy)});
}

// The stack lies in memory. Any other address that is not known may be a peripheral's.
bool FunctionBound::on_bus(std::size_t node) const {
  const auto& instruction = flow_.nodes[node].instruction;
  const Value base = reached_.before[node]->registers[instruction.first];
  if (base.is_constant()) return !analysis_.program_.in_memory(base.offset + instruction.immediate);
  return base.base != stack_pointer;
}

Clocks FunctionBound::called(std::size_t node) {
  const Node& caller = flow_.nodes[node];
  const auto targets = callees(analysis_.program_, flow_, reached_, node);
  if (targets.empty()) {
    add_problem(caller.address, "the function called here is not known",
                "call it by its name, or declare the table of its pointer (units/call_table.hpp)");
  }
  const unsigned link = caller.calls ? caller.instruction.destination : entry_.link;
  Clocks longest = 0;
  for (const Address target : targets) {
    if (!analysis_.program_.is_code(target)) {
      if (caller.calls) {
        add_problem(caller.address, "what is called here lies outside the code", "jump to it");
      }
      // Another program takes over, and does not return.
      continue;
    }
    const auto clocks = analysis_.bound({.address = target, .link = link}, *reached_.before[node]);
    is_bounded_ = is_bounded_ && clocks;
    longest = std::max(longest, clocks.value_or(0));
  }
  return longest;
}

Clocks FunctionBound::cost(std::size_t node, const Way* way) {
  const Node& from = flow_.nodes[node];
  Clocks clocks = analysis_.costs_.of(from.instruction, way != nullptr && way->taken, on_bus(node));
  if (from.calls || from.end == End::goes_on_elsewhere) return clocks + called(node);
  if (way != nullptr) {
    clocks += analysis_.costs_.between(from.instruction, flow_.nodes[way->to].instruction);
  }
  return clocks;
}

FunctionBound::Level FunctionBound::level(std::size_t start, const Loop* loop) {
  Level result;
  std::map<std::size_t, Clocks> distance{{start, 0}};
  const auto go = [&](std::size_t to, Clocks clocks) {
    if (loop != nullptr && to == start) {
      raise(result.again, clocks);
    } else if (loop != nullptr && !loop->nodes[to]) {
      raise(result.exits, to, clocks);
    } else {
      raise(distance, to, clocks);
    }
  };
  for (const std::size_t node : loops_.order) {
    const auto here = distance.find(node);
    if (here == distance.end()) continue;
    const Clocks clocks = here->second;
    const auto inner = levels_.find(node);
    if (inner != levels_.end() && (loop == nullptr || node != start)) {
      for (const auto& [to, more] : inner->second.exits) go(to, clocks + more);
      if (inner->second.end) raise(result.end, clocks + *inner->second.end);
      continue;
    }
    if (ways_[node].empty()) raise(result.end, clocks + cost(node, nullptr));
    for (const Way& way : ways_[node]) go(way.to, clocks + cost(node, &way));
  }
  return result;
}

// Each way in by itself, since one alone may bring a number that is known.
std::optional<Clocks> FunctionBound::counted_rounds(const Loop& loop) const {
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

std::optional<Clocks> FunctionBound::counted_rounds(const Loop& loop, State state) const {
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

std::optional<Clocks> FunctionBound::most_rounds(const Loop& loop) {
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

bool FunctionBound::only_sleeps(const Loop& loop) const {
  for (std::size_t node = 0; node < flow_.nodes.size(); ++node) {
    const Operation operation = flow_.nodes[node].instruction.operation;
    if (loop.nodes[node] && operation != Operation::wait_for_interrupt &&
        operation != Operation::jump) {
      return false;
    }
  }
  return true;
}

FunctionBound::Level FunctionBound::rounds(const Loop& loop) {
  Level result = level(loop.header, &loop);
  if (result.exits.empty() && !result.end) {
    if (only_sleeps(loop)) return {.again = {}, .end = 0, .exits = {}};
    add_problem(flow_.nodes[loop.header].address, "a loop has no end",
                "ask for the bound of what it calls");
    return {.again = {}, .end = 0, .exits = {}};
  }
  const Clocks all = most_rounds(loop).value_or(0) * result.again.value_or(0);
  for (auto& [to, clocks] : result.exits) clocks += all;
  if (result.end) *result.end += all;
  return result;
}

std::optional<Clocks> FunctionBound::longest() {
  if (loops_.second_entry) {
    add_problem(flow_.nodes[*loops_.second_entry].address, "a loop has several entries",
                "write it without goto, or with the test in one place");
    return std::nullopt;
  }
  for (const Loop& loop : loops_.loops) levels_[loop.header] = rounds(loop);
  const Level whole = level(0, nullptr);
  return is_bounded_ ? whole.end : std::nullopt;
}

}  // namespace timing
