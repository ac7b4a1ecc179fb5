// SPDX-License-Identifier: Apache-2.0
// Smaller networks with the same ways.
#include "tools/timing/network.hpp"

namespace timing {

namespace {

void append(std::vector<std::size_t>& to, const std::vector<std::size_t>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

void remove_dead_ends(Network& network) {
  std::vector<std::vector<std::size_t>> before(network.end + 1);
  for (const Arc& arc : network.arcs) before[arc.to].push_back(arc.from);
  std::vector<bool> ends(network.end + 1);
  std::vector<std::size_t> open{network.end};
  ends[network.end] = true;
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    for (const std::size_t from : before[node]) {
      if (ends[from]) continue;
      ends[from] = true;
      open.push_back(from);
    }
  }
  std::erase_if(network.arcs, [&](const Arc& arc) { return !ends[arc.to]; });
}

// The way out of a node is joined to the way in.
void join_chains(Network& network) {
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> ins(network.end + 1), outs(network.end + 1), out(network.end + 1, none);
  for (std::size_t i = 0; i < network.arcs.size(); ++i) {
    ++ins[network.arcs[i].to];
    ++outs[network.arcs[i].from];
    out[network.arcs[i].from] = i;
  }
  const auto is_link = [&](std::size_t node) {
    return node != 0 && node != network.end && ins[node] == 1 && outs[node] == 1;
  };
  std::vector<Arc> joined;
  for (const Arc& first : network.arcs) {
    if (is_link(first.from)) continue;
    Arc whole = first;
    while (is_link(whole.to)) {
      const Arc& next = network.arcs[out[whole.to]];
      whole.to = next.to;
      whole.clocks += next.clocks;
      append(whole.calls, next.calls);
      append(whole.events, next.events);
      append(whole.begins, next.begins);
    }
    joined.push_back(std::move(whole));
  }
  network.arcs = std::move(joined);
}

}  // namespace

void Network::make_round(std::size_t start) {
  const auto moved = [start](std::size_t node) {
    return node == start ? 0 : node == 0 ? start : node;
  };
  for (Arc& arc : arcs) {
    arc.to = arc.to == start ? end : moved(arc.to);
    arc.from = moved(arc.from);
  }
  for (RoundsBound& loop : loops) {
    loop.header = moved(loop.header);
    std::vector<bool>::swap(loop.nodes[start], loop.nodes[0]);
  }
}

void Network::reduce() {
  remove_dead_ends(*this);
  join_chains(*this);
}

}  // namespace timing
