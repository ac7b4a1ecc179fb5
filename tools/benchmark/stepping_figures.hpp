// SPDX-License-Identifier: Apache-2.0
// What `bench stepping` measures, for hardware and for software. All in clocks of the chip, so
// exact and the same on every machine.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/benchmark/rate_search.hpp"
#include "tools/benchmark/scope.hpp"
#include "tools/benchmark/stepping_run.hpp"

namespace benchmarks {

// The shortest intervals between ticks.
struct LoopRates {
  std::size_t axes{};
  DriverGuard guard;
  Limits lines;  // of 500 ticks one after the other
  Limits one_line;  // where software has no line to hand over
};

struct JitterFigure {
  double interval_clocks{};
  Jitter jitter;
};

struct Train {
  bool saturated{};  // the serial line
  double hertz{};
  Jitter jitter;
};

struct Share {
  std::uint32_t interval_clocks{};
  double busy{};
  bool clean{};
};

// What is left of the processor where a driver's pulse is wide.
struct DriverShare {
  DriverGuard guard;
  Share share;  // lines of 500 ticks
};

struct Figures {
  Stepping stepping{};
  std::vector<LoopRates> loops;
  std::vector<JitterFigure> jitter;
  std::vector<Train> trains;
  std::vector<Share> shares;  // four axes, lines of 50 ticks, no driver
  std::vector<DriverShare> driver_shares;  // four axes
};

// `say` is called with what is measured now.
Figures measure(Stepping stepping, const sim::ElfImage& program, const Scope& scope,
                const std::function<void(const std::string&)>& say);

}  // namespace benchmarks
