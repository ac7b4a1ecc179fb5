// SPDX-License-Identifier: Apache-2.0
// States along the ways, until nothing changes any more.
#include "tools/timing/reach.hpp"

namespace timing {

using processor::Operation;

std::optional<Address> Reach::target(const Node& node, const State& before) {
  if (node.instruction.operation == Operation::jump) return node.instruction.immediate;
  const Value value = before.registers[node.instruction.first];
  if (!value.is_constant()) return std::nullopt;
  return (value.offset + node.instruction.immediate) & ~Address{1};
}

std::vector<Way> Reach::ways(const Node& node, const State& before) {
  std::vector<Way> found = node.ways;
  if (found.size() < 2) return found;
  if (const auto taken = decide(node.instruction, before)) {
    std::erase_if(found, [&](const Way& way) { return way.taken != *taken; });
  }
  return found;
}

State Reach::after(const Node& node, State state) const {
  const auto called = node.calls ? target(node, state) : std::nullopt;
  execute(program_, node.address, node.instruction, state);
  if (!node.calls) return state;
  if (node.instruction.destination != second_link || !called) {
    forget_what_calls_change(node.address, state);
    return state;
  }
  // The code that saves registers moves the stack pointer, and changes no argument.
  const Flow& flow = flows_.of({.address = *called, .link = second_link});
  const Reached reached = all(flow, state);
  std::optional<State> end;
  for (std::size_t i = 0; i < flow.nodes.size(); ++i) {
    if (flow.nodes[i].end != End::returns || !reached.before[i]) continue;
    if (end) {
      join_at(node.address, *end, *reached.before[i]);
    } else {
      end = reached.before[i];
    }
  }
  return end.value_or(state);
}

Reached Reach::run(const Flow& flow, std::size_t start, const State& state,
                   const std::vector<bool>* within) const {
  Reached reached;
  reached.before.resize(flow.nodes.size());
  reached.before[start] = state;
  std::vector<std::size_t> open{start};
  while (!open.empty()) {
    const std::size_t index = open.back();
    open.pop_back();
    ++reached.visits;
    const Node& node = flow.nodes[index];
    const State before = *reached.before[index];
    const State behind = after(node, before);
    for (const Way& way : ways(node, before)) {
      if (within != nullptr && !(*within)[way.to]) continue;
      const bool is_back = within != nullptr && way.to == start;
      auto& known = is_back ? reached.back : reached.before[way.to];
      const std::optional<State> old = known;
      if (!known) known = behind;
      join_at(flow.nodes[way.to].address, *known, behind);
      if (!is_back && known != old) open.push_back(way.to);
    }
  }
  return reached;
}

Reached Reach::all(const Flow& flow, const State& state) const {
  return run(flow, 0, state, nullptr);
}

Reached Reach::once(const Flow& flow, std::size_t start, const State& state,
                    const std::vector<bool>& within) const {
  return run(flow, start, state, &within);
}

}  // namespace timing
