// SPDX-License-Identifier: Apache-2.0
// The parameters of a heater and its block in the machine description.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace thermal {

struct HeaterProperties {
  std::int32_t rise{};  // mK/s at full power without loss; 0: not described, nothing is watched
  // Of the difference to the surroundings, in millionths lost per second: in still air, what the
  // fan at full speed adds, what each mm/s of filament adds.
  std::int32_t loss{};
  std::int32_t fan_loss{};
  std::int32_t filament_loss{};
  // From the gate to the block, and from there to the sensor.
  units::Milliseconds heater_lag{};
  units::Milliseconds sensor_lag{};
  // The heater at hand may have so much of the rise and of the losses above, in percent.
  std::int32_t least_power{100}, most_power{100};
  std::int32_t least_loss{100}, most_loss{100};
  std::int32_t draught{};  // adds so much to the loss in still air at times, in percent
  units::Millicelsius missing_limit{};  // rise that may be missing before it is a fault
  units::Milliseconds window{1'000};  // of one comparison
};

}  // namespace thermal
