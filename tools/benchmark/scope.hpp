// SPDX-License-Identifier: Apache-2.0
// Settings that all measurements of `bench stepping` share.
#pragma once

#include <cstdint>
#include <functional>

#include "tools/benchmark/lateness.hpp"

namespace benchmarks {

struct Scope {
  std::uint32_t clock_hz = 50'000'000;
  bool quick = false;  // fewer and shorter runs, to see that all works
  double tolerance_us = default_tolerance_us;  // within which a tick is punctual
  // Called many times a second; what it throws ends the measurement.
  std::function<void()> look = [] {};

  double tolerance_clocks() const { return tolerance_us * 1e-6 * clock_hz; }
};

}  // namespace benchmarks
