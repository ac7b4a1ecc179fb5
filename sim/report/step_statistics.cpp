// SPDX-License-Identifier: Apache-2.0
// Counting of steps in bins of intervals.
#include "sim/report/step_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace report {

StepStatistics::StepStatistics(sim::ClockRate rate) : rate_(rate) {
  last_edge_.fill(sim::never);
  shortest_.fill(sim::never);
}

void StepStatistics::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= axes) return;
  sim::Clock& last = last_edge_[edge.axis];
  if (last != sim::never) {
    const sim::Clock interval = edge.clock - last;
    shortest_[edge.axis] = std::min(shortest_[edge.axis], interval);
    const double microseconds = 1e6 * rate_.seconds(interval);
    const double bin = std::floor(std::log10(microseconds) * static_cast<double>(bins_per_decade));
    if (bin < static_cast<double>(bins)) {
      ++intervals_[edge.axis][static_cast<std::size_t>(std::max(bin, 0.0))];
    }
  }
  last = edge.clock;
}

double StepStatistics::max_step_rate_hz(std::size_t axis) const {
  return shortest_[axis] == sim::never ? 0.0 : 1.0 / rate_.seconds(shortest_[axis]);
}

double StepStatistics::bin_start_us(std::size_t bin) {
  return std::pow(10.0, static_cast<double>(bin) / static_cast<double>(bins_per_decade));
}

}  // namespace report
