// SPDX-License-Identifier: Apache-2.0
// Arcs from the ways, loops from what the code shows or the source declares.
#include "tools/timing/function_network.hpp"

#include <algorithm>

#include "tools/timing/callees.hpp"

namespace timing {

namespace {

using processor::Operation;

std::vector<std::vector<Way>> possible_ways(const Flow& flow, const Reached& reached) {
  std::vector<std::vector<Way>> ways(flow.nodes.size());
  for (std::size_t i = 0; i < flow.nodes.size(); ++i) {
    if (reached.before[i]) ways[i] = Reach::ways(flow.nodes[i], *reached.before[i]);
  }
  return ways;
}

Graph graph_of(const std::vector<std::vector<Way>>& ways) {
  Graph graph(ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i) {
    for (const Way& way : ways[i]) graph[i].push_back(way.to);
  }
  return graph;
}

}  // namespace

FunctionNetwork::FunctionNetwork(Analysis& analysis, const Flow& flow, Entry entry,
                                 const State& start, FactSet under_way)
    : analysis_(analysis),
      flow_(flow),
      entry_(entry),
      start_(start),
      reached_(analysis.reach_.all(flow, start)),
      ways_(possible_ways(flow, reached_)),
      graph_(graph_of(ways_)),
      loops_(find_loops(graph_)),
      events_(analysis.program_, analysis.facts_, flow, ways_, under_way),
      happening_(events_.happening()) {}

void FunctionNetwork::add_problem(Address address, std::string what, std::string remedy) {
  is_bounded_ = false;
  analysis_.tree_.add({.place = analysis_.program_.place_of(address),
                       .function = analysis_.program_.name_of(entry_.address),
                       .what = std::move(what),
                       .remedy = std::move(remedy)});
}

// The stack lies in memory, and so does each object. An address that is not known is a peripheral's
// at most where the function has an access of the bus.
bool FunctionNetwork::on_bus(std::size_t node) const {
  const auto& instruction = flow_.nodes[node].instruction;
  const Value base = reached_.before[node]->registers[instruction.first];
  const Program& program = analysis_.program_;
  if (base.is_constant()) return !program.in_memory(base.offset + instruction.immediate);
  return base.base != stack_pointer && program.may_access_bus(flow_.nodes[node].address);
}

std::vector<FunctionNetwork::Passage> FunctionNetwork::called(std::size_t node, const Link& link) {
  const Node& caller = flow_.nodes[node];
  const auto targets = callees(analysis_.program_, flow_, reached_, node);
  if (targets.empty()) {
    add_problem(caller.address, "the function called here is not known",
                "call it by its name, or declare the table of its pointer (units/call_table.hpp)");
  }
  const unsigned register_of_return = caller.calls ? caller.instruction.destination : entry_.link;
  std::vector<Passage> passages;
  Passage longest;
  for (const Address target : targets) {
    if (!analysis_.program_.is_code(target)) {
      if (caller.calls) {
        add_problem(caller.address, "what is called here lies outside the code", "jump to it");
      }
      // Another program takes over, and does not return.
      continue;
    }
    const Entry callee{.address = target, .link = register_of_return};
    const State& registers = *reached_.before[node];
    const auto bound = analysis_.bound(callee, registers);
    is_bounded_ = is_bounded_ && bound;
    if (!bound) continue;
    happening_ |= bound->happening;
    if (const FactSet limits = bound->happening & events_.under_way(node); limits != 0) {
      passages.push_back({.linked = link(callee, registers, limits)});
    } else {
      longest.clocks = std::max(longest.clocks, bound->clocks);
    }
  }
  if (passages.size() < targets.size() || passages.empty()) passages.push_back(longest);
  return passages;
}

Clocks FunctionNetwork::cost(std::size_t node, const Way* way) const {
  const Node& from = flow_.nodes[node];
  Clocks clocks = analysis_.costs_.of(from.instruction, way != nullptr && way->taken, on_bus(node));
  if (way != nullptr && !from.calls) {
    clocks += analysis_.costs_.between(from.instruction, flow_.nodes[way->to].instruction);
  }
  return clocks;
}

// To the end without a way.
void FunctionNetwork::add_arcs(std::size_t node, const Way* way, const Link& link) {
  const Node& from = flow_.nodes[node];
  const bool is_access =
      is_load(from.instruction.operation) || is_store(from.instruction.operation);
  if (is_access && on_bus(node) && !analysis_.program_.may_access_bus(from.address)) {
    add_problem(from.address, "an access of the bus, of which the source does not say so",
                "read and write registers by platform/bus.hpp");
  }
  Arc arc{.from = node,
          .to = way == nullptr ? network_.end : way->to,
          .clocks = cost(node, way),
          .calls = {},
          .events = {},
          .begins = {}};
  if (way != nullptr) {
    EventSites::Passed passed = events_.on(node, *way);
    arc.events = std::move(passed.events);
    arc.begins = std::move(passed.begins);
  }
  if (!from.calls && from.end != End::goes_on_elsewhere) {
    network_.arcs.push_back(std::move(arc));
    return;
  }
  for (const Passage& passage : called(node, link)) {
    Arc through = arc;
    through.clocks += passage.clocks;
    if (passage.linked) through.calls.push_back(*passage.linked);
    network_.arcs.push_back(std::move(through));
  }
}

bool FunctionNetwork::has_one_entry() {
  if (!loops_.second_entry) return true;
  add_problem(flow_.nodes[*loops_.second_entry].address, "a loop has several entries",
              "write it without goto, or with the test in one place");
  return false;
}

std::optional<Network> FunctionNetwork::round(const Link& link) {
  if (loops_.loops.empty()) {
    add_problem(entry_.address, "the function has no loop", "ask for the bound of the function");
    return std::nullopt;
  }
  if (!has_one_entry()) return std::nullopt;
  const Loop& around = loops_.loops.back();
  network_.end = flow_.nodes.size();
  for (const std::size_t node : loops_.order) {
    if (!around.nodes[node]) continue;
    for (const Way& way : ways_[node]) {
      if (around.nodes[way.to]) add_arcs(node, &way, link);
    }
  }
  for (const Loop& loop : loops_.loops) {
    if (around.nodes[loop.header] && loop.header != around.header) add_loop(loop);
  }
  // What holds for all rounds together holds for one.
  network_.entry_begins = members(events_.under_way(around.header));
  network_.make_round(around.header);
  network_.reduce();
  if (!is_bounded_) return std::nullopt;
  return std::move(network_);
}

std::vector<std::size_t> FunctionNetwork::nodes_at(const std::set<Address>& places) const {
  std::vector<std::size_t> nodes;
  for (const std::size_t node : loops_.order) {
    if (places.contains(flow_.nodes[node].address)) nodes.push_back(node);
  }
  return nodes;
}

std::optional<Network> FunctionNetwork::span(const Link& link, const std::set<Address>& begins,
                                             const std::set<Address>& ends) {
  if (!has_one_entry()) return std::nullopt;
  const auto starts = nodes_at(begins);
  std::vector<bool> stops(flow_.nodes.size()), within(flow_.nodes.size());
  for (const std::size_t node : nodes_at(ends)) stops[node] = true;
  std::vector<std::size_t> open = starts;
  FactSet under_way = 0;
  for (const std::size_t node : starts) {
    within[node] = true;
    under_way |= events_.under_way(node);
  }
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    for (const Way& way : ways_[node]) {
      if (stops[way.to] || within[way.to]) continue;
      within[way.to] = true;
      open.push_back(way.to);
    }
  }
  // One more node leads to all beginnings.
  const std::size_t start = flow_.nodes.size();
  network_.end = start + 1;
  for (const std::size_t node : starts) {
    network_.arcs.push_back(
        {.from = start, .to = node, .clocks = 0, .calls = {}, .events = {}, .begins = {}});
  }
  for (const std::size_t node : loops_.order) {
    if (!within[node]) continue;
    for (const Way& way : ways_[node]) add_arcs(node, &way, link);
  }
  for (Arc& arc : network_.arcs) {
    if (arc.to < stops.size() && stops[arc.to]) arc.to = network_.end;
  }
  for (const Loop& loop : loops_.loops) {
    const bool goes_round = std::ranges::any_of(network_.arcs, [&](const Arc& arc) {
      return arc.to == loop.header && arc.from != start && loop.nodes[arc.from];
    });
    if (!goes_round) continue;
    if (std::ranges::any_of(starts, [&](std::size_t node) { return loop.nodes[node]; })) {
      add_problem(flow_.nodes[loop.header].address, "a task does not end in its round",
                  "end its TaskSpan on all ways (units/task_span.hpp)");
      continue;
    }
    add_loop(loop);
  }
  for (RoundsBound& loop : network_.loops) loop.nodes.resize(start + 1);
  network_.entry_begins = members(under_way);
  network_.make_round(start);
  network_.reduce();
  if (!is_bounded_) return std::nullopt;
  return std::move(network_);
}

std::optional<Network> FunctionNetwork::network(const Link& link) {
  if (!has_one_entry()) return std::nullopt;
  network_.end = flow_.nodes.size();
  EventSites::Passed passed = events_.on_entry();
  network_.entry_events = std::move(passed.events);
  network_.entry_begins = std::move(passed.begins);
  for (const std::size_t node : loops_.order) {
    if (ways_[node].empty()) add_arcs(node, nullptr, link);
    for (const Way& way : ways_[node]) add_arcs(node, &way, link);
  }
  for (const Loop& loop : loops_.loops) add_loop(loop);
  network_.reduce();
  if (!is_bounded_) return std::nullopt;
  return std::move(network_);
}

}  // namespace timing
