// SPDX-License-Identifier: Apache-2.0
// Which marker counts for which loop.
#include "tools/timing/markers.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace timing {

namespace {

using Kind = std::pair<std::uint32_t, std::uint32_t>;  // most, tag

Kind kind_of(const LoopMarker& marker) { return {marker.most, marker.tag}; }

class Search {
 public:
  Search(const std::vector<LoopMarker>& markers, const Flow& flow, const Graph& graph,
         const Loops& loops, const Loop& loop)
      : markers_(markers), graph_(graph), loops_(loops), loop_(loop) {
    for (std::size_t node = 0; node < flow.nodes.size(); ++node) {
      nodes_[flow.nodes[node].address] = node;
    }
  }

  std::optional<std::uint64_t> rounds() const {
    std::map<Kind, std::vector<std::size_t>> found;
    for (const LoopMarker& marker : markers_) {
      const auto node = nodes_.find(marker.address);
      if (marker.is_end == 0 && node != nodes_.end() && counts(marker, node->second)) {
        found[kind_of(marker)].push_back(node->second);
      }
    }
    std::optional<std::uint64_t> least;
    const auto take = [&](std::uint64_t rounds) {
      least = std::min(least.value_or(rounds), rounds);
    };
    for (const auto& [kind, nodes] : found) {
      const bool one_is_enough =
          std::ranges::any_of(nodes, [&](std::size_t node) { return every_round_passes({node}); });
      if (one_is_enough) {
        take(kind.first);
      } else if (every_round_passes(nodes)) {
        // Each may belong to an object of its own.
        take(std::uint64_t{kind.first} * nodes.size());
      }
    }
    return least;
  }

 private:
  bool counts(const LoopMarker& marker, std::size_t node) const {
    if (node == loop_.header && latches() > 1) {
      // Some of them may lead to behind the marker.
      return false;
    }
    const Loop* owner = nullptr;  // inner loops come first
    for (const Loop& around : loops_.loops) {
      if (!around.nodes[node] || ends_in(marker, around)) continue;
      if (owner == nullptr || is_at_start_of_a_loop(node)) owner = &around;
    }
    return owner == &loop_;
  }

  bool is_at_start_of_a_loop(std::size_t node) const {
    return std::ranges::any_of(loops_.loops, [&](const Loop& loop) { return loop.header == node; });
  }

  bool ends_in(const LoopMarker& marker, const Loop& loop) const {
    return std::ranges::any_of(markers_, [&](const LoopMarker& end) {
      const auto node = nodes_.find(end.address);
      return end.is_end != 0 && kind_of(end) == kind_of(marker) && node != nodes_.end() &&
             loop.nodes[node->second];
    });
  }

  std::size_t latches() const {
    std::size_t count = 0;
    for (std::size_t node = 0; node < graph_.size(); ++node) {
      if (loop_.nodes[node] && std::ranges::contains(graph_[node], loop_.header)) ++count;
    }
    return count;
  }

  bool every_round_passes(const std::vector<std::size_t>& marked) const {
    if (std::ranges::contains(marked, loop_.header)) return true;
    std::vector<bool> seen(graph_.size());
    std::vector<std::size_t> open{loop_.header};
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      for (const std::size_t to : graph_[node]) {
        if (to == loop_.header) return false;
        if (!loop_.nodes[to] || seen[to] || std::ranges::contains(marked, to)) continue;
        seen[to] = true;
        open.push_back(to);
      }
    }
    return true;
  }

  const std::vector<LoopMarker>& markers_;
  const Graph& graph_;
  const Loops& loops_;
  const Loop& loop_;
  std::map<Address, std::size_t> nodes_;
};

}  // namespace

std::optional<std::uint64_t> declared_rounds(const std::vector<LoopMarker>& markers,
                                             const Flow& flow, const Graph& graph,
                                             const Loops& loops, const Loop& loop) {
  return Search(markers, flow, graph, loops, loop).rounds();
}

}  // namespace timing
