// SPDX-License-Identifier: Apache-2.0
// Rows and columns from networks.
#include "tools/timing/linear_program.hpp"

#include <map>
#include <optional>

namespace timing {

RowNumbers::RowNumbers(const Networks& networks) {
  for (const Network& network : networks.networks) {
    nodes.push_back(count);
    count += network.end;
    loops.push_back(count);
    count += network.loops.size();
  }
  facts = count;
  count += networks.facts.size();
}

namespace {

using Entries = std::map<std::size_t, std::int64_t>;

class Builder {
 public:
  explicit Builder(const Networks& networks) : networks_(networks), rows_(networks) {}

  LinearProgram program() {
    program_.rows.resize(rows_.count);
    for (std::size_t i = 0; i < networks_.networks.size(); ++i) {
      const Network& network = networks_.networks[i];
      for (std::size_t j = 0; j < network.loops.size(); ++j) {
        program_.rows[rows_.loop(i, j)].is_equation = false;
      }
      for (const Arc& arc : network.arcs) add(i, arc);
    }
    for (std::size_t i = 0; i < networks_.facts.size(); ++i) {
      program_.rows[rows_.fact(i)].is_equation = false;
    }
    // The run of the first network, whose factors are those of a call.
    Entries run;
    enter(0, run);
    for (const auto& [row, factor] : run) program_.rows[row].right_side = -factor;
    return std::move(program_);
  }

 private:
  void add(std::size_t index, const Arc& arc) {
    Entries entries;
    entries[rows_.node(index, arc.from)] += 1;
    reach(index, arc.to, arc.from, entries);
    for (const std::size_t called : arc.calls) enter(called, entries);
    count(arc.events, arc.begins, entries);
    Column column{.clocks = static_cast<std::int64_t>(arc.clocks), .entries = {}};
    for (const auto& [row, factor] : entries) {
      if (factor != 0) column.entries.emplace_back(row, factor);
    }
    program_.columns.push_back(std::move(column));
  }

  // Where it comes from decides whether a loop begins or goes on.
  void reach(std::size_t index, std::size_t to, std::optional<std::size_t> from, Entries& entries) {
    const Network& network = networks_.networks[index];
    if (to == network.end) return;
    entries[rows_.node(index, to)] -= 1;
    for (std::size_t i = 0; i < network.loops.size(); ++i) {
      const RoundsBound& loop = network.loops[i];
      if (loop.header != to) continue;
      const bool is_back = from && loop.nodes[*from];
      entries[rows_.loop(index, i)] += is_back ? 1 : -static_cast<std::int64_t>(loop.most);
    }
  }

  void enter(std::size_t index, Entries& entries) {
    reach(index, 0, std::nullopt, entries);
    const Network& network = networks_.networks[index];
    count(network.entry_events, network.entry_begins, entries);
  }

  void count(const std::vector<std::size_t>& events, const std::vector<std::size_t>& begins,
             Entries& entries) {
    for (const std::size_t fact : events) entries[rows_.fact(fact)] += 1;
    for (const std::size_t fact : begins) entries[rows_.fact(fact)] -= networks_.facts[fact].most;
  }

  const Networks& networks_;
  RowNumbers rows_;
  LinearProgram program_;
};

}  // namespace

LinearProgram program_of(const Networks& networks) { return Builder(networks).program(); }

}  // namespace timing
