// SPDX-License-Identifier: Apache-2.0
// One run of the stepping benchmark's program on the chip: what was asked, and what the pins did.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "firmware/benchmark/stepping.hpp"
#include "sim/simulation/elf_image.hpp"
#include "tools/benchmark/driver_guards.hpp"
#include "tools/benchmark/pin_watch.hpp"
#include "tools/benchmark/scope.hpp"

namespace sim {
class VerilatedChip;
}

namespace benchmarks {

enum class Stepping : std::uint8_t { hardware, software };
constexpr const char* name_of(Stepping stepping) {
  return stepping == Stepping::hardware ? "hardware" : "software";
}

// Lines at one rate, one after the other without a pause, back and forth.
struct Motion {
  double interval_clocks{};  // between two ticks
  std::uint32_t ticks_per_line{};
  std::uint32_t lines{};
  std::size_t axes = 1;  // the first steps at each tick, the others at parts of them
  DriverGuard guard = no_driver;
  std::uint32_t baud{};  // the serial line is saturated in both directions; 0: silent
};

struct Run {
  std::array<PinWatch::Axis, axes> pins;
  std::array<std::uint64_t, axes> asked{};  // pulses
  benchmark::SteppingResult result{};
  std::uint32_t late_ticks{};
  // Of a tick, by the pins. It means nothing where not all pulses were made.
  double largest_lateness_clocks{};
  double busy_share{};  // of the processor's clocks while steps were made
  bool ended{};

  // Every pulse, the guard kept, no tick late or delayed, the queue never empty.
  bool clean(const Motion& motion) const { return fault(motion).empty(); }
  // The first of these that does not hold, in words.
  std::string_view fault(const Motion& motion) const;
};

// The rule that a run must meet; once it is broken, the run ends.
struct Demand {
  bool clean = false;
  double latest_clocks = std::numeric_limits<double>::infinity();  // after its exact instant
};

// The program with the motion as its order, into the memory of a chip that has not run.
void load_motion(const sim::ElfImage& program, const Motion& motion, sim::VerilatedChip& chip);

Run run_motion(const sim::ElfImage& program, const Motion& motion, const Scope& scope,
               const Demand& demand = {});

// Intervals between the steps of an axis.
struct Jitter {
  std::uint64_t intervals{};
  sim::Clock shortest{};
  sim::Clock longest{};
  double mean{};
  double standard_deviation{};
};
Jitter jitter_of(const std::vector<sim::Clock>& rises);

}  // namespace benchmarks
