// SPDX-License-Identifier: Apache-2.0
// One bound for each function and each set of constant arguments.
#include "tools/timing/analysis.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "tools/timing/function_network.hpp"
#include "tools/timing/longest_time.hpp"

namespace timing {

namespace {

std::optional<Network> whole(FunctionNetwork& function, const FunctionNetwork::Link& link) {
  return function.network(link);
}

}  // namespace

// The network of a function, and of those that it calls in which facts limit events: one for each
// set of constant arguments and of facts.
class Analysis::Linker {
 public:
  explicit Linker(Analysis& analysis) : analysis_(analysis) {}

  // Nothing where a function has no bound.
  std::optional<Networks> networks(Entry entry, const State& at_call, const Part& part) {
    add(entry, at_call, 0, part);
    if (!is_bounded_) return std::nullopt;
    // Facts without an event limit nothing.
    const bool has_events = std::ranges::any_of(found_, [](const Network& network) {
      return !network.entry_events.empty() ||
             std::ranges::any_of(network.arcs, [](const Arc& arc) { return !arc.events.empty(); });
    });
    if (has_events) return Networks{std::move(found_), analysis_.facts_};
    for (Network& network : found_) {
      network.entry_begins.clear();
      for (Arc& arc : network.arcs) arc.begins.clear();
    }
    return Networks{std::move(found_), {}};
  }

  FactSet happening() const { return happening_; }

 private:
  std::size_t add(Entry entry, const State& at_call, FactSet under_way, const Part& part) {
    const State start = state_in_callee(analysis_.program_, at_call);
    const auto [known, is_new] =
        numbers_.try_emplace({context_of(entry, start), under_way}, found_.size());
    const std::size_t number = known->second;
    if (!is_new) return number;
    found_.emplace_back();
    FunctionNetwork function(analysis_, analysis_.flows_.of(entry), entry, start, under_way);
    const auto link = [&](Entry callee, const State& registers, FactSet facts) {
      return add(callee, registers, facts, whole);
    };
    auto network = part(function, link);
    is_bounded_ = is_bounded_ && network;
    if (network) found_[number] = std::move(*network);
    if (number == 0) happening_ = function.happening();
    return number;
  }

  Analysis& analysis_;
  std::map<std::pair<Context, FactSet>, std::size_t> numbers_;
  std::vector<Network> found_;
  FactSet happening_ = 0;
  bool is_bounded_ = true;
};

Analysis::Analysis(const Program& program, const Costs& costs, bool has_zbb)
    : program_(program),
      costs_(costs),
      flows_(program, has_zbb),
      reach_(program, flows_),
      facts_(facts_of(program)),
      tree_(program) {}

std::optional<Clocks> Analysis::bound(Address function) {
  const auto found = bound(entry_of(program_, function), State::at_start());
  return found ? std::optional(found->clocks) : std::nullopt;
}

std::optional<Networks> Analysis::networks(Address function) {
  return Linker(*this).networks(entry_of(program_, function), State::at_start(), whole);
}

std::optional<Clocks> Analysis::round(Address function) {
  const Entry entry = entry_of(program_, function);
  return part_of(entry,
                 [](FunctionNetwork& network, const Link& link) { return network.round(link); });
}

std::optional<Clocks> Analysis::span(Address function, const std::set<Address>& begins,
                                     const std::set<Address>& ends) {
  const Entry entry = entry_of(program_, function);
  return part_of(entry, [&](FunctionNetwork& network, const Link& link) {
    return network.span(link, begins, ends);
  });
}

std::optional<Clocks> Analysis::part_of(Entry entry, const Part& part) {
  try {
    const auto found = measure(entry, state_in_callee(program_, State::at_start()), part);
    if (found) return found->clocks;
  } catch (const Unbounded& error) {
    add(error.problem());
  }
  return std::nullopt;
}

Address Analysis::round_start(Address function) {
  const Entry entry = entry_of(program_, function);
  const Flow& flow = flows_.of(entry);
  return FunctionNetwork(*this, flow, entry, state_in_callee(program_, State::at_start()), 0)
      .round_start();
}

std::optional<Analysis::Bound> Analysis::bound(Entry entry, const State& at_call) {
  return tree_.of(entry, at_call,
                  [&](Entry begun, const State& start) { return measure(begun, start, whole); });
}

std::optional<Analysis::Bound> Analysis::measure(Entry entry, const State& start,
                                                 const Part& part) {
  Linker linker(*this);
  const auto networks = linker.networks(entry, start, part);
  if (!networks) return std::nullopt;
  const LongestTime longest = longest_time(*networks);
  if (longest.kind == LongestTime::Kind::proved) {
    return Bound{.clocks = longest.clocks, .happening = linker.happening()};
  }
  const bool contradicts = longest.kind == LongestTime::Kind::contradiction;
  tree_.add({.place = program_.place_of(entry.address),
             .function = program_.name_of(entry.address),
             .what = contradicts ? "no path keeps to the bounds of its events"
                     : longest.kind == LongestTime::Kind::too_long
                         ? "the numbers of the proof do not fit"
                         : "the solver found no solution",
             .remedy = contradicts ? "an EventBound is too small (units/event_bound.hpp)"
                                   : "declare smaller bounds of its loops"});
  return std::nullopt;
}

}  // namespace timing
