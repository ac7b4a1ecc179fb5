// SPDX-License-Identifier: Apache-2.0
// All that counts in the chip while its blocks are at rest.
#pragma once

#include <array>
#include <cstdint>

#include "sim/counting/counters.hpp"
#include "sim/counting/fan.hpp"
#include "sim/counting/time_base.hpp"
#include "sim/simulation/evaluation_counts.hpp"

namespace counting {

struct Counts {
  Timer timer;
  std::uint64_t motion_time{};  // of the step generator
  std::uint64_t processor_cycles{};  // mcycle
  bool processor_cycles_stopped{};
  Phase converter_tick, heater_tick, heater_slot;
  Cycles converter_cycles;
  std::array<std::uint32_t, sim::most_heaters> converter_wakes{};
  MotionWatchdog motion_watchdog;
  TimeBase time_base;
  Fan fan;

  // Up to `most` clocks, none if they are fewer than `least`; ends after the first clock that
  // changes more than counts. Returns the clocks carried over.
  sim::Clock carry(sim::Clock most, sim::Clock least);

  // What ended a carry() of these counts over so many clocks, which were fewer than it was given.
  sim::LeapEnd end_of(sim::Clock clocks) const;

  bool operator==(const Counts&) const = default;
};

}  // namespace counting
