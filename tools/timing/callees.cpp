// SPDX-License-Identifier: Apache-2.0
// Constant targets first, then tables.
#include "tools/timing/callees.hpp"

#include <optional>
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

bool is_reached(const Flow& flow, const Reached& reached, Address place) {
  for (std::size_t i = 0; i < flow.nodes.size(); ++i) {
    if (flow.nodes[i].address == place) return reached.before[i].has_value();
  }
  return false;
}

// Nothing where the table may change.
std::optional<std::set<Address>> functions_in(const Program& program, const CallTable& table) {
  std::set<Address> found;
  for (Address at = table.first; at - table.first + 4 <= table.bytes; at += 4) {
    const auto word = program.constant_at(at, 4);
    if (!word) return std::nullopt;
    if (program.is_code(*word)) found.insert(*word);
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
    if (!is_reached(flow, reached, table.place)) continue;
    places.insert(table.place);
    const auto functions = functions_in(program, table);
    if (!functions) return {};
    found.insert(functions->begin(), functions->end());
  }
  if (places.size() < calls_by_pointer(flow, reached)) return {};
  return {found.begin(), found.end()};
}

}  // namespace timing
