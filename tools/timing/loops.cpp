// SPDX-License-Identifier: Apache-2.0
// Dominators (Cooper, Harvey, Kennedy, "A Simple, Fast Dominance Algorithm", 2001) and back edges.
#include "tools/timing/loops.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace timing {

namespace {

std::vector<std::size_t> reverse_post_order(const Graph& graph) {
  std::vector<std::size_t> order;
  std::vector<bool> seen(graph.size());
  std::vector<std::pair<std::size_t, std::size_t>> path{{0, 0}};
  seen[0] = true;
  while (!path.empty()) {
    auto& [node, next] = path.back();
    if (next == graph[node].size()) {
      order.push_back(node);
      path.pop_back();
    } else if (const std::size_t to = graph[node][next++]; !seen[to]) {
      seen[to] = true;
      path.emplace_back(to, 0);
    }
  }
  std::ranges::reverse(order);
  return order;
}

}  // namespace

Loops find_loops(const Graph& graph) {
  Loops result{.order = reverse_post_order(graph), .loops = {}, .second_entry = {}};
  const std::size_t none = graph.size();
  std::vector<std::size_t> rank(graph.size(), none), dominator(graph.size(), none);
  for (std::size_t i = 0; i < result.order.size(); ++i) rank[result.order[i]] = i;
  std::vector<std::vector<std::size_t>> before(graph.size());
  for (const std::size_t node : result.order) {
    for (const std::size_t to : graph[node]) before[to].push_back(node);
  }
  dominator[0] = 0;
  for (bool changes = true; changes;) {
    changes = false;
    for (const std::size_t node : result.order) {
      if (node == 0) continue;
      std::size_t common = none;
      for (std::size_t other : before[node]) {
        if (dominator[other] == none) continue;
        if (common == none) common = other;
        while (common != other) {
          while (rank[other] > rank[common]) other = dominator[other];
          while (rank[common] > rank[other]) common = dominator[common];
        }
      }
      changes = changes || dominator[node] != common;
      dominator[node] = common;
    }
  }
  const auto dominates = [&](std::size_t above, std::size_t node) {
    while (rank[node] > rank[above]) node = dominator[node];
    return node == above;
  };
  std::map<std::size_t, Loop> by_header;
  for (const std::size_t node : result.order) {
    for (const std::size_t to : graph[node]) {
      if (rank[to] > rank[node]) continue;
      if (!dominates(to, node)) {
        result.second_entry = to;
        continue;
      }
      Loop& loop =
          by_header.try_emplace(to, Loop{to, std::vector<bool>(graph.size()), 1}).first->second;
      loop.nodes[to] = true;
      std::vector<std::size_t> open{node};
      while (!open.empty()) {
        const std::size_t inner = open.back();
        open.pop_back();
        if (loop.nodes[inner]) continue;
        loop.nodes[inner] = true;
        ++loop.size;
        open.insert(open.end(), before[inner].begin(), before[inner].end());
      }
    }
  }
  for (auto& [header, loop] : by_header) result.loops.push_back(std::move(loop));
  std::ranges::sort(result.loops, {}, &Loop::size);
  return result;
}

}  // namespace timing
