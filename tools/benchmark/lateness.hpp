// SPDX-License-Identifier: Apache-2.0
// How late ticks are made, by the pins alone: each against the exact instant at which it is due.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tools/benchmark/pin_watch.hpp"

namespace benchmarks {

// By default a tick is punctual up to this time after its exact instant: the least time that an
// A4988 needs between two edges, and a hundredth of the interval at 10 000 steps/s.
inline constexpr double default_tolerance_us = 1.0;

// The clocks in which any axis steps, in order, each once: axes that step at one tick do
// so at once.
std::vector<sim::Clock> ticks_of(const std::array<PinWatch::Axis, axes>& pins);

// By how much the latest of the ticks so far is late where one is due every `interval_clocks`. Time
// counts from the most punctual of them: no tick is made before its instant, and what delays
// all of them alike delays none against another. A tick that is missing, or one too many, makes
// others late by whole intervals.
class RunningLateness {
 public:
  explicit RunningLateness(double interval_clocks) : interval_clocks_(interval_clocks) {}

  // All ticks from the first one on; those of earlier calls are not examined again.
  void add(std::span<const sim::Clock> ticks);
  double clocks() const { return latest_ - earliest_; }

 private:
  double interval_clocks_;
  std::size_t seen_ = 0;
  double earliest_ = 0, latest_ = 0;  // clocks after its instant, if the first tick were exact
};
double largest_lateness(std::span<const sim::Clock> ticks, double interval_clocks);

// The same where all that is known of the interval is that it is constant: of the even series that
// suits the ticks best.
double largest_lateness_in_even_series(std::span<const sim::Clock> ticks);

}  // namespace benchmarks
