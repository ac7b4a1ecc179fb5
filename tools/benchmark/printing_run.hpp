// SPDX-License-Identifier: Apache-2.0
// One run of the whole firmware, which prints lines of G-code on a machine that limits nothing, and
// what its pins did.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/machine/description.hpp"
#include "sim/simulation/elf_image.hpp"
#include "tools/benchmark/pin_watch.hpp"
#include "tools/benchmark/scope.hpp"

namespace benchmarks {

// Lines of one direction, one after the other, from rest to rest.
struct Printing {
  double interval_clocks{};  // between two ticks at the feed rate that is requested
  std::uint32_t ticks_per_line{};  // a multiple of 100
  std::uint32_t lines{};
  std::size_t axes = 1;  // X steps at each tick, the others at parts of them

  // From rest to that rate it takes 5000 ticks, or more where the machine is not so fast.
  static double acceleration_hz_per_s(double interval_clocks, std::uint32_t clock_hz);
  static std::uint32_t ramp_ticks(double interval_clocks, std::uint32_t clock_hz);
};

struct PrintingRun {
  std::array<PinWatch::Axis, axes> pins;
  std::array<std::uint64_t, axes> asked{};  // pulses
  std::uint64_t underruns{};
  std::uint64_t delay_clocks{};  // of the time base, by the guard or by late ticks
  std::uint64_t late_ticks{};
  bool ended{};
  std::string complaint;  // of the chip, about a line
  double middle_interval_clocks{};  // mean, of X, in the middle half of the motion
  // Of a tick there, where the rate is constant, by the pins.
  double largest_lateness_clocks{};

  // Every pulse, the guard kept, no tick late or delayed, the queue never empty at speed, and in
  // the middle half of the motion the rate that was requested.
  bool clean(const Printing& printing) const { return fault(printing).empty(); }
  // The first of these that does not hold, in words.
  std::string_view fault(const Printing& printing) const;
};

// Prints to the end, or until it is no longer clean where only that is asked. `description` is the
// machine that the firmware is built for.
PrintingRun run_printing(const sim::ElfImage& firmware, const machine::Description& description,
                         const Printing& printing, const Scope& scope, bool until_unclean = false);

}  // namespace benchmarks
