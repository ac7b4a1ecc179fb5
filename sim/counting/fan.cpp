// SPDX-License-Identifier: Apache-2.0
// From slot to slot.
#include "sim/counting/fan.hpp"

namespace counting {

namespace {

constexpr std::uint8_t last_slot = 254;
constexpr std::uint32_t slot_mask = 0xff'ffff;

}  // namespace

void Fan::next_slot() {
  if (slot == last_slot) {
    slot = 0;
    slots_on = static_cast<std::uint8_t>(duty);
    level = slots_on != 0;
  } else {
    ++slot;
    level = slot < slots_on;
  }
}

sim::Clock Fan::carry(sim::Clock most) {
  const bool before = level;
  sim::Clock clocks = 0;
  while (clocks < most && level == before) {
    if (remaining_cycles > most - clocks) {
      remaining_cycles -= static_cast<std::uint32_t>(most - clocks);
      return most;
    }
    clocks += remaining_cycles;
    remaining_cycles = 0;
    if (clocks == most) break;
    // The last clock of a slot.
    ++clocks;
    next_slot();
    const std::uint32_t cycles = slot_cycles & slot_mask;
    remaining_cycles = cycles == 0 ? 0 : cycles - 1;
  }
  return clocks;
}

}  // namespace counting
