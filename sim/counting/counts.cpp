// SPDX-License-Identifier: Apache-2.0
// Advances all counters as far as every block only counts.
#include "sim/counting/counts.hpp"

#include <algorithm>

namespace counting {

sim::Clock Counts::carry(sim::Clock most, sim::Clock least) {
  sim::Clock clocks = std::min({most, timer.quiet(), converter_tick.quiet(), heater_tick.quiet(),
                                heater_slot.quiet(), motion_watchdog.quiet()});
  for (const std::uint32_t wake : converter_wakes) {
    clocks = std::min(clocks, converter_cycles.quiet_until(wake));
  }
  if (clocks < least) return 0;

  // These two find the end themselves.
  TimeBase carried_base = time_base;
  clocks = carried_base.carry(clocks);
  if (clocks < least) return 0;
  Fan carried_fan = fan;
  const sim::Clock clocks_of_fan = carried_fan.carry(clocks);
  if (clocks_of_fan < clocks) {
    if (clocks_of_fan < least) return 0;
    clocks = clocks_of_fan;
    carried_base = time_base;
    carried_base.carry(clocks);
  }
  time_base = carried_base;
  fan = carried_fan;

  timer.carry(clocks);
  motion_time += clocks;
  processor_cycles += processor_cycles_stopped ? 0 : clocks;
  converter_tick.carry(clocks);
  heater_tick.carry(clocks);
  heater_slot.carry(clocks);
  converter_cycles.carry(clocks);
  motion_watchdog.carry(clocks);
  return clocks;
}

sim::LeapEnd Counts::end_of(sim::Clock clocks) const {
  if (timer.quiet() == clocks) return sim::LeapEnd::timer;
  if (converter_tick.quiet() == clocks) return sim::LeapEnd::converter;
  for (const std::uint32_t wake : converter_wakes) {
    if (converter_cycles.quiet_until(wake) == clocks) return sim::LeapEnd::converter;
  }
  if (heater_tick.quiet() == clocks || heater_slot.quiet() == clocks) return sim::LeapEnd::heater;
  if (motion_watchdog.quiet() == clocks) return sim::LeapEnd::motion_watchdog;
  // One clock more is given, and not taken.
  return Fan(fan).carry(clocks + 1) == clocks ? sim::LeapEnd::fan : sim::LeapEnd::time_base;
}

}  // namespace counting
