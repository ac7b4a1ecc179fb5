// SPDX-License-Identifier: Apache-2.0
// The distribution of step intervals and the highest step rate, per axis.
#pragma once

#include <array>
#include <cstdint>

#include "sim/devices/step_edge.hpp"
#include "sim/simulation/clock_rate.hpp"

namespace report {

class StepStatistics : public devices::StepListener {
 public:
  static constexpr std::size_t axes = 5;  // x y z e, and e of a second extruder
  // Intervals from 1 us to 1 s in logarithmic bins.
  static constexpr std::size_t bins_per_decade = 20;
  static constexpr std::size_t bins = 6 * bins_per_decade;
  using Histogram = std::array<std::uint64_t, bins>;

  explicit StepStatistics(sim::ClockRate rate);

  void stepped(const devices::StepEdge& edge) override;

  const std::array<Histogram, axes>& intervals() const { return intervals_; }
  // 1 / the shortest interval between two edges; 0 where there are none.
  double max_step_rate_hz(std::size_t axis) const;
  static double bin_start_us(std::size_t bin);

 private:
  sim::ClockRate rate_;
  std::array<Histogram, axes> intervals_{};
  std::array<sim::Clock, axes> last_edge_;
  std::array<sim::Clock, axes> shortest_;
};

}  // namespace report
