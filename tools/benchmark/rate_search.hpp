// SPDX-License-Identifier: Apache-2.0
// The search for the highest rate at which all ticks meet a rule.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace benchmarks {

// The rule for the ticks. Clean: every pulse is made, the guard is kept, and no tick is so late
// that the next one is due. Punctual: clean, and each tick comes within the tolerance of its
// exact instant.
enum class Rule : std::uint8_t { clean, punctual };

// What a run has shown.
struct Trial {
  std::string fault;  // empty: it was clean
  double largest_lateness_clocks{};  // where it was clean
};

// The shortest interval between ticks at which a rule holds.
struct Limit {
  std::uint32_t interval_clocks{};
  double largest_lateness_clocks{};  // at this interval
  std::string limited_by;  // what happens at a shorter one; empty where none is shorter
  // The rule held at this shorter interval, too, but not at one between; 0: at none.
  std::uint32_t also_clocks{};
};

struct Limits {
  Limit clean, punctual;

  const Limit& of(Rule rule) const { return rule == Rule::clean ? clean : punctual; }
  // In words, for the progress display.
  std::string text() const;
};

class RateSearch {
 public:
  // A run may end early once it is not clean, or once a tick is later than this number of clocks.
  using Run = std::function<Trial(std::uint32_t interval_clocks, double late_enough_clocks)>;

  // Intervals are searched to within `fineness`, a part of them, but at least to one clock.
  RateSearch(Run run, double tolerance_clocks, double fineness);

  // By bisection from `start`, the shortest interval that is worth a try. Whether a rule holds may
  // change more than once from shorter to longer intervals, so a slightly longer one is tried as
  // well; where it does not hold there, the search starts over above it. Throws std::runtime_error
  // where it holds nowhere.
  Limits limits(std::uint32_t start);

 private:
  bool holds(std::uint32_t interval, Rule rule);
  Limit limit(std::uint32_t start, Rule rule);
  std::uint32_t shortest_above(std::uint32_t failing, std::uint32_t start, Rule rule);
  std::string fault_below(std::uint32_t interval) const;

  Run run_;
  double tolerance_clocks_;
  double fineness_;
  std::map<std::uint32_t, Trial> trials_;
};

}  // namespace benchmarks
