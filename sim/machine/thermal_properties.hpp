// SPDX-License-Identifier: Apache-2.0
// Heat capacities and losses of the simulated hotend and bed, as measured ones of the field lie.
#pragma once

#include "sim/plants/heated_block.hpp"

namespace machine {

inline constexpr double ambient_celsius = 22.0;

// An all-metal hotend: 20 g aluminium block with a 40 W cartridge, bead in a hole of the block.
// Holding 205 °C takes about a third of the power, heating up about 100 s.
constexpr plants::HeatedBlockProperties hotend_properties(double heater_watts) {
  return {.heater_watts = heater_watts,
          .path = {.heater_joules_per_kelvin = 2.5,
                   .heater_to_block_watts_per_kelvin = 2.0,
                   .block_joules_per_kelvin = 12.0,
                   .sensor_lag_seconds = 1.5},
          .loss_watts_per_kelvin = 0.07,
          .fan_loss_watts_per_kelvin = 0.025};
}

// A circuit board heater under 200 mm of glass. Holding 60 °C takes about a third of the power,
// heating up about four minutes.
constexpr plants::HeatedBlockProperties bed_properties(double heater_watts) {
  return {.heater_watts = heater_watts,
          .path = {.heater_joules_per_kelvin = 120.0,
                   .heater_to_block_watts_per_kelvin = 25.0,
                   .block_joules_per_kelvin = 420.0,
                   .sensor_lag_seconds = 3.0},
          .loss_watts_per_kelvin = 1.1,
          .fan_loss_watts_per_kelvin = 0.15};
}

}  // namespace machine
