// SPDX-License-Identifier: Apache-2.0
// Constant targets first, then tables.
#include "tools/timing/callees.hpp"

#include <algorithm>
#include <ranges>
#include <set>

namespace timing {

namespace {

bool goes_away(const Node& node) { return node.calls || node.end == End::goes_on_elsewhere; }

std::size_t calls_by_pointer(const Flow& flow, const Reached& reached) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < flow.nodes.size(); ++i) {
    const auto& before = reached.before[i];
    if (before && goes_away(flow.nodes[i]) && !Reach::target(flow.nodes[i], *before)) ++count;
  }
  return count;
}

std::vector<Address> functions_in(const Program& program, const CallTable& table) {
  std::vector<Address> found;
  for (Address at = table.first; at - table.first + 4 <= table.bytes; at += 4) {
    const auto word = program.constant_at(at, 4);
    if (word && program.is_code(*word)) found.push_back(*word);
  }
  return found;
}

}  // namespace

std::vector<Address> callees(const Program& program, const Flow& flow, const Reached& reached,
                             std::size_t node) {
  if (const auto target = Reach::target(flow.nodes[node], *reached.before[node])) return {*target};
  std::set<Address> found;
  std::set<Address> places;
  for (const CallTable& table : program.call_tables) {
    if (!std::ranges::contains(flow.nodes, table.place, &Node::address)) continue;
    places.insert(table.place);
    for (const Address function : functions_in(program, table)) found.insert(function);
  }
  if (places.size() < calls_by_pointer(flow, reached)) return {};
  return {found.begin(), found.end()};
}

}  // namespace timing
