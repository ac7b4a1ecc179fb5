// SPDX-License-Identifier: Apache-2.0
// What `bench stepping` measures, for hardware and for software. All in clocks of the chip, so
// exact and the same on every machine.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/benchmark/stepping_run.hpp"

namespace benchmarks {

// The shortest interval between ticks at which a motion is clean.
struct CleanRate {
  std::size_t axes{};
  std::uint32_t guard_clocks{};
  // Lines of 500 ticks one after the other.
  std::uint32_t lines_clocks{};
  // Within one line, where software has no line to hand over.
  std::uint32_t one_line_clocks{};
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

struct Figures {
  Stepping stepping{};
  std::vector<CleanRate> clean;
  std::vector<JitterFigure> jitter;
  std::vector<Train> trains;
  std::vector<Share> shares;  // four axes
};

struct Scope {
  std::uint32_t clock_hz = 50'000'000;
  bool quick = false;  // fewer and shorter runs, to see that all works
};

// `say` is told what is measured now.
Figures measure(Stepping stepping, const sim::ElfImage& program, const Scope& scope,
                const std::function<void(const std::string&)>& say);

}  // namespace benchmarks
