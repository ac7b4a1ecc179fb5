// SPDX-License-Identifier: Apache-2.0
// Lateness against an even series, and the search for the series.
#include "tools/benchmark/lateness.hpp"

#include <algorithm>

namespace benchmarks {

std::vector<sim::Clock> ticks_of(const std::array<PinWatch::Axis, axes>& pins) {
  std::vector<sim::Clock> ticks;
  for (const PinWatch::Axis& axis : pins) {
    ticks.insert(ticks.end(), axis.rises.begin(), axis.rises.end());
  }
  std::ranges::sort(ticks);
  const auto repeated = std::ranges::unique(ticks);
  ticks.erase(repeated.begin(), repeated.end());
  return ticks;
}

void RunningLateness::add(std::span<const sim::Clock> ticks) {
  for (; seen_ < ticks.size(); ++seen_) {
    const auto after_first = static_cast<double>(ticks[seen_] - ticks.front());
    const double late = after_first - interval_clocks_ * static_cast<double>(seen_);
    earliest_ = std::min(earliest_, late);
    latest_ = std::max(latest_, late);
  }
}

double largest_lateness(std::span<const sim::Clock> ticks, double interval_clocks) {
  RunningLateness lateness(interval_clocks);
  lateness.add(ticks);
  return lateness.clocks();
}

// The largest lateness is convex in the interval (a maximum of straight lines), and where it
// is least the last tick is off by no more than with the mean interval: so a search in
// thirds finds it.
double largest_lateness_in_even_series(std::span<const sim::Clock> ticks) {
  if (ticks.size() < 2) return 0;
  const auto intervals = static_cast<double>(ticks.size() - 1);
  const double mean = static_cast<double>(ticks.back() - ticks.front()) / intervals;
  const double reach = largest_lateness(ticks, mean) / intervals;
  // Less than this changes no tick of the series by a thousandth of a clock.
  const double precision = 1e-3 / intervals;
  double shortest = mean - reach;
  double longest = mean + reach;
  while (longest - shortest > precision) {
    const double third = (longest - shortest) / 3;
    if (largest_lateness(ticks, shortest + third) < largest_lateness(ticks, longest - third)) {
      longest -= third;
    } else {
      shortest += third;
    }
  }
  return largest_lateness(ticks, (shortest + longest) / 2);
}

}  // namespace benchmarks
