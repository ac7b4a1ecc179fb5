// SPDX-License-Identifier: Apache-2.0
// Climbing until the rule holds, bisection, and a look at a longer interval.
#include "tools/benchmark/rate_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace benchmarks {

namespace {

// 500 steps/s at 50 MHz: slower than that is another fault.
constexpr std::uint32_t longest_interval = 100'000;
// Relative lengthening of an interval, to see that the rule still holds.
constexpr double longer_part = 0.02;
constexpr const char* not_punctual = "ticks beyond the tolerance";

std::uint32_t part_of(std::uint32_t interval, double part) {
  return static_cast<std::uint32_t>(interval * part) + 1;
}

}  // namespace

std::string Limits::text() const {
  return fmt::format("clean every {} clocks, punctual every {}", clean.interval_clocks,
                     punctual.interval_clocks);
}

RateSearch::RateSearch(Run run, double tolerance_clocks, double fineness)
    : run_(std::move(run)), tolerance_clocks_(tolerance_clocks), fineness_(fineness) {}

Limits RateSearch::limits(std::uint32_t start) {
  trials_.clear();
  // In this order: a run that ended because it was not punctual does not show whether it was clean.
  const Limit clean = limit(start, Rule::clean);
  return {clean, limit(clean.interval_clocks, Rule::punctual)};
}

bool RateSearch::holds(std::uint32_t interval, Rule rule) {
  const auto [place, is_new] = trials_.try_emplace(interval);
  Trial& trial = place->second;
  if (is_new) {
    const double endless = std::numeric_limits<double>::infinity();
    trial = run_(interval, rule == Rule::clean ? endless : tolerance_clocks_);
  }
  if (rule == Rule::punctual && trial.fault.empty() &&
      trial.largest_lateness_clocks > tolerance_clocks_) {
    trial.fault = not_punctual;
  }
  return trial.fault.empty();
}

std::uint32_t RateSearch::shortest_above(std::uint32_t failing, std::uint32_t start, Rule rule) {
  std::uint32_t good = start;
  for (std::uint32_t more = part_of(good, 0.25); !holds(good, rule); more *= 2) {
    failing = good;
    good += more;
    if (good > longest_interval) throw std::runtime_error("no rate will do: " + fault_below(good));
  }
  while (good - failing > part_of(good, fineness_)) {
    const std::uint32_t middle = failing + (good - failing) / 2;
    (holds(middle, rule) ? good : failing) = middle;
  }
  return good;
}

Limit RateSearch::limit(std::uint32_t start, Rule rule) {
  Limit result;
  std::uint32_t good = shortest_above(start - 1, start, rule);
  for (;;) {
    const std::uint32_t longer = good + part_of(good, longer_part);
    if (holds(longer, rule)) break;
    if (result.also_clocks == 0) result.also_clocks = good;
    good = shortest_above(longer, longer + 1, rule);
  }
  result.interval_clocks = good;
  result.largest_lateness_clocks = trials_.at(good).largest_lateness_clocks;
  result.limited_by = fault_below(good);
  return result;
}

std::string RateSearch::fault_below(std::uint32_t interval) const {
  for (auto trial = trials_.lower_bound(interval); trial != trials_.begin();) {
    --trial;
    if (!trial->second.fault.empty()) return trial->second.fault;
  }
  return {};
}

}  // namespace benchmarks
