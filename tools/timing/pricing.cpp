// SPDX-License-Identifier: Apache-2.0
// From called networks to their callers, in each from inner loops outwards.
#include "tools/timing/pricing.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace timing {

namespace {

// Far from what overflows in a sum of few.
constexpr Wide largest = Wide{1} << 120;

Wide checked(Wide value) {
  if (value > largest || value < -largest) throw std::overflow_error("a time is too long");
  return value;
}

Wide product(Wide factor, Wide other) {
  Wide result = 0;
  if (__builtin_mul_overflow(factor, other, &result)) {
    throw std::overflow_error("a time is too long");
  }
  return checked(result);
}

class Pricing {
 public:
  Pricing(const Networks& networks, std::int64_t scale, const std::vector<Wide>& of_facts)
      : networks_(networks), rows_(networks), runs_(networks.networks.size()) {
    prices_.scale = scale;
    prices_.of_rows.resize(rows_.count);
    for (std::size_t fact = 0; fact < of_facts.size(); ++fact) {
      prices_.of_rows[rows_.fact(fact)] = of_facts[fact];
    }
  }

  Prices all() {
    for (std::size_t i = 0; i < networks_.networks.size(); ++i) of_run(i);
    return std::move(prices_);
  }

 private:
  // Of a run of a network. Functions do not call themselves.
  Wide of_run(std::size_t index) {
    if (!runs_[index]) runs_[index] = find(index);
    return *runs_[index];
  }

  Wide find(std::size_t index) {
    const Network& network = networks_.networks[index];
    std::vector<Wide> clocks;
    for (const Arc& arc : network.arcs) {
      Wide sum = product(prices_.scale, arc.clocks);
      for (const std::size_t called : arc.calls) sum += of_run(called);
      clocks.push_back(checked(sum + of_facts(arc.events, arc.begins)));
    }
    Wide entry = of_facts(network.entry_events, network.entry_begins);
    for (std::size_t i = 0; i < network.loops.size(); ++i) {
      const RoundsBound& loop = network.loops[i];
      const Wide round = std::max<Wide>(longest_round(network, loop, clocks), 0);
      prices_.of_rows[rows_.loop(index, i)] = round;
      const Wide all_rounds = product(round, loop.most);
      for (std::size_t arc = 0; arc < network.arcs.size(); ++arc) {
        const auto& [from, to] = std::pair(network.arcs[arc].from, network.arcs[arc].to);
        if (to != loop.header) continue;
        clocks[arc] = checked(clocks[arc] + (loop.nodes[from] ? -round : all_rounds));
      }
      if (loop.header == 0) entry += all_rounds;
    }
    const auto to_end = longest_ways(network, clocks);
    for (std::size_t node = 0; node < network.end; ++node) {
      prices_.of_rows[rows_.node(index, node)] = to_end[node].value_or(0);
    }
    return checked(entry + to_end[0].value_or(0));
  }

  Wide of_facts(const std::vector<std::size_t>& events, const std::vector<std::size_t>& begins) {
    Wide sum = 0;
    for (const std::size_t fact : events) sum -= prices_.of_rows[rows_.fact(fact)];
    for (const std::size_t fact : begins) {
      sum += product(prices_.of_rows[rows_.fact(fact)], networks_.facts[fact].most);
    }
    return checked(sum);
  }

  using Ways = std::vector<std::optional<Wide>>;

  // Inner loops have their prices, so that a further round of them gains nothing.
  static Wide longest_round(const Network& network, const RoundsBound& loop,
                            const std::vector<Wide>& clocks) {
    Ways ways(network.end + 1);
    ways[loop.header] = 0;
    std::optional<Wide> round;
    const auto arcs = within(network, loop);
    for (std::size_t pass = 0; pass <= network.end; ++pass) {
      bool changes = false;
      for (const std::size_t i : arcs) {
        const Arc& arc = network.arcs[i];
        if (!ways[arc.from]) continue;
        const Wide way = checked(*ways[arc.from] + clocks[i]);
        auto& known = arc.to == loop.header ? round : ways[arc.to];
        if (known && *known >= way) continue;
        known = way;
        changes = true;
      }
      if (!changes) break;
    }
    return round.value_or(0);
  }

  static std::vector<std::size_t> within(const Network& network, const RoundsBound& loop) {
    std::vector<std::size_t> arcs;
    for (std::size_t i = 0; i < network.arcs.size(); ++i) {
      const Arc& arc = network.arcs[i];
      if (arc.to != network.end && loop.nodes[arc.from] && loop.nodes[arc.to]) arcs.push_back(i);
    }
    return arcs;
  }

  static Ways longest_ways(const Network& network, const std::vector<Wide>& clocks) {
    Ways ways(network.end + 1);
    ways[network.end] = 0;
    for (std::size_t pass = 0; pass <= network.end; ++pass) {
      bool changes = false;
      for (std::size_t i = network.arcs.size(); i-- > 0;) {
        const Arc& arc = network.arcs[i];
        if (!ways[arc.to]) continue;
        const Wide way = checked(*ways[arc.to] + clocks[i]);
        if (ways[arc.from] && *ways[arc.from] >= way) continue;
        ways[arc.from] = way;
        changes = true;
      }
      if (!changes) break;
    }
    return ways;
  }

  const Networks& networks_;
  RowNumbers rows_;
  Prices prices_;
  std::vector<std::optional<Wide>> runs_;
};

}  // namespace

Prices price(const Networks& networks, std::int64_t scale, const std::vector<Wide>& of_facts) {
  return Pricing(networks, scale, of_facts).all();
}

}  // namespace timing
