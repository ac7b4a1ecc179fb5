// SPDX-License-Identifier: Apache-2.0
// Which runs are surely under way: along all ways, until nothing changes any more.
#include "tools/timing/event_sites.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace timing {

namespace {

FactSet bit(std::size_t fact) { return FactSet{1} << fact; }

bool matches(const Fact& fact, const EventMarker& marker) {
  return fact.event == marker.event && fact.most == marker.most;
}

}  // namespace

std::vector<std::size_t> members(FactSet set) {
  std::vector<std::size_t> found;
  for (std::size_t fact = 0; fact < 64; ++fact) {
    if ((set & bit(fact)) != 0) found.push_back(fact);
  }
  return found;
}

std::vector<Fact> facts_of(const Program& program) {
  std::set<Fact> found;
  for (const EventMarker& marker : program.event_markers) {
    if (marker.kind == EventMarker::begin) found.insert({marker.event, marker.most});
  }
  if (found.size() > 64) throw std::runtime_error("more than 64 facts about events");
  return {found.begin(), found.end()};
}

EventSites::EventSites(const Program& program, const std::vector<Fact>& facts, const Flow& flow,
                       const std::vector<std::vector<Way>>& ways, FactSet at_entry)
    : facts_(facts),
      flow_(flow),
      at_entry_(at_entry),
      markers_(flow.nodes.size()),
      ways_in_(flow.nodes.size()),
      behind_what_never_returns_(flow.nodes.size()),
      after_(flow.nodes.size(), ~FactSet{0}) {
  std::map<Address, std::size_t> places;
  for (std::size_t i = 0; i < flow.nodes.size(); ++i) {
    places[flow.nodes[i].address] = i;
    for (const Way& way : flow.nodes[i].ways) ++ways_in_[way.to];
  }
  for (const Node& node : flow.nodes) {
    const auto next = places.find(node.address + node.instruction.bytes);
    if (node.calls && node.end == End::halts && next != places.end()) {
      behind_what_never_returns_[next->second] = true;
    }
  }
  for (const EventMarker& marker : program.event_markers) {
    const auto place = places.find(marker.address);
    if (place == places.end()) continue;
    markers_[place->second].push_back(marker);
    if (marker.kind != EventMarker::event_happens) continue;
    for (std::size_t i = 0; i < facts.size(); ++i) {
      if (facts[i].event == marker.event) happening_ |= bit(i);
    }
  }
  std::vector<FactSet> before(flow.nodes.size(), ~FactSet{0});
  before[0] = at_entry;
  for (bool changes = true; changes;) {
    changes = false;
    for (std::size_t i = 0; i < flow.nodes.size(); ++i) {
      after_[i] = after_markers(i, before[i]);
      for (const Way& way : ways[i]) {
        const FactSet known = before[way.to];
        before[way.to] &= after_[i];
        changes = changes || before[way.to] != known;
      }
    }
  }
}

FactSet EventSites::after_markers(std::size_t node, FactSet before) const {
  for (const EventMarker& marker : markers_[node]) {
    for (std::size_t i = 0; i < facts_.size(); ++i) {
      if (!matches(facts_[i], marker)) continue;
      if (marker.kind == EventMarker::begin) before |= bit(i);
      if (marker.kind == EventMarker::end) before &= ~bit(i);
    }
  }
  return before;
}

EventSites::Passed EventSites::pass(std::size_t to, FactSet before, bool is_sure) const {
  Passed passed;
  for (const EventMarker& marker : markers_[to]) {
    for (std::size_t i = 0; i < facts_.size(); ++i) {
      const bool is_under_way = (before & bit(i)) != 0;
      if (marker.kind == EventMarker::event_happens) {
        if (is_sure && is_under_way && facts_[i].event == marker.event) passed.events.push_back(i);
      } else if (matches(facts_[i], marker)) {
        if (marker.kind == EventMarker::begin && !is_under_way) passed.begins.push_back(i);
        before = marker.kind == EventMarker::begin ? before | bit(i) : before & ~bit(i);
      }
    }
  }
  return passed;
}

EventSites::Passed EventSites::on(std::size_t node, const Way& way) const {
  return pass(way.to, after_[node], surely_passes(node, way));
}

// A marker at the start may be the last of the function in front of it.
EventSites::Passed EventSites::on_entry() const { return pass(0, at_entry_, false); }

bool EventSites::surely_passes(std::size_t node, const Way& way) const {
  const Node& from = flow_.nodes[node];
  const bool is_next = from.address + from.instruction.bytes == flow_.nodes[way.to].address;
  const bool jumps =
      way.taken || (from.instruction.operation == processor::Operation::jump && !from.calls);
  if (is_next && !jumps) return true;
  return way.to != 0 && ways_in_[way.to] == 1 && !behind_what_never_returns_[way.to];
}

}  // namespace timing
