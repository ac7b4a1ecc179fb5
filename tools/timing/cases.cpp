// SPDX-License-Identifier: Apache-2.0
#include "tools/timing/cases.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace timing {

namespace {

// Of a solution in floating point: less is nothing.
constexpr double least = 1e-6;

std::size_t times(const std::vector<std::size_t>& facts, std::size_t fact) {
  return static_cast<std::size_t>(std::ranges::count(facts, fact));
}

bool holds(const std::vector<std::size_t>& facts, std::size_t fact) {
  return times(facts, fact) != 0;
}

bool lies_in_loop(const Network& network, const Arc& arc) {
  return std::ranges::any_of(network.loops,
                             [&](const RoundsBound& loop) { return loop.nodes[arc.from]; });
}

// One run, in the network that is passed once, outside of its loops.
bool begins_once(const Networks& networks, std::size_t fact) {
  std::size_t once = 0, often = 0;
  for (std::size_t i = 0; i < networks.networks.size(); ++i) {
    const Network& network = networks.networks[i];
    (i == 0 ? once : often) += times(network.entry_begins, fact);
    for (const Arc& arc : network.arcs) {
      (i == 0 && !lies_in_loop(network, arc) ? once : often) += times(arc.begins, fact);
    }
  }
  return once == 1 && often == 0;
}

// Calls f(events, number of the arc), of all arcs.
template <class AllNetworks, class F>
void for_each_arc(AllNetworks& networks, F f) {
  std::size_t number = 0;
  for (auto& network : networks.networks) {
    for (auto& arc : network.arcs) f(arc.events, number++);
  }
}

bool is_in_entries(const Networks& networks, std::size_t fact) {
  return std::ranges::any_of(
      networks.networks, [&](const Network& network) { return holds(network.entry_events, fact); });
}

struct Places {
  std::optional<std::size_t> twice;  // an arc on which the event happens more than once
  std::optional<std::size_t> most;  // the one that is passed most
  std::size_t count = 0;
};

// That are passed.
Places places_of(const Networks& networks, std::size_t fact, const std::vector<double>& passes) {
  Places places;
  for_each_arc(networks, [&](const std::vector<std::size_t>& events, std::size_t arc) {
    if (!holds(events, fact) || passes[arc] < least) return;
    ++places.count;
    if (times(events, fact) > 1) places.twice = arc;
    if (!places.most || passes[arc] > passes[*places.most]) places.most = arc;
  });
  return places;
}

// The event does not happen on those arcs: another fact says so.
template <class Is>
Networks without(Networks networks, std::size_t fact, Is is_left_out) {
  const std::size_t never = networks.facts.size();
  networks.facts.push_back({.event = networks.facts[fact].event, .most = 0});
  for_each_arc(networks, [&](std::vector<std::size_t>& events, std::size_t arc) {
    if (holds(events, fact) && is_left_out(arc)) events.push_back(never);
  });
  return networks;
}

}  // namespace

std::vector<Networks> cases_of(const Networks& networks, const std::vector<double>& passes) {
  for (std::size_t fact = 0; fact < networks.facts.size(); ++fact) {
    if (networks.facts[fact].most != 1 || is_in_entries(networks, fact)) continue;
    const Places places = places_of(networks, fact, passes);
    if ((places.count < 2 && !places.twice) || !begins_once(networks, fact)) continue;
    const std::size_t one = places.twice.value_or(places.most.value());
    std::vector<Networks> cases{
        without(networks, fact, [=](std::size_t arc) { return arc == one; })};
    if (!places.twice) {
      cases.push_back(without(networks, fact, [=](std::size_t arc) { return arc != one; }));
    }
    return cases;
  }
  return {};
}

}  // namespace timing
