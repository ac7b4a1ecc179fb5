// SPDX-License-Identifier: Apache-2.0
// The fan's slots and its pulse width, as rtl/thermal/fan.vhd and rtl/common/pulse_width.vhd
// count them.
#pragma once

#include <cstdint>

#include "sim/simulation/pins.hpp"

namespace counting {

struct Fan {
  std::uint32_t slot_cycles{};  // software's words: 24 and 8 bits of them count
  std::uint32_t duty{};
  std::uint32_t remaining_cycles{};
  std::uint8_t slot{};
  std::uint8_t slots_on{};
  bool level{};

  // Up to `most` clocks; ends where the level has changed. Returns the clocks carried over.
  sim::Clock carry(sim::Clock most);

  bool operator==(const Fan&) const = default;

 private:
  void next_slot();
};

}  // namespace counting
