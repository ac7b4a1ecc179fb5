// SPDX-License-Identifier: Apache-2.0
// The end stop switches: how they are wired, and which are triggered. Hardware stops the motion.
#pragma once

#include <cstdint>

namespace drivers {

// Bit n belongs to input n.
struct EndStopSettings {
  // Inputs that have a switch; others are never triggered.
  std::uint8_t enabled{};
  // Inputs that are triggered while their pin is low.
  std::uint8_t active_low{};
  // Clocks for which a level must last; the switch is seen so much later.
  std::uint16_t filter_cycles{};
};

class EndStops {
 public:
  void configure(const EndStopSettings& settings);

  // What the step generator sees; a new setting shows after its filter time.
  std::uint8_t triggered() const;
  // Pin levels before and after the filter.
  std::uint8_t raw_levels() const;
  std::uint8_t filtered_levels() const;
};

}  // namespace drivers
