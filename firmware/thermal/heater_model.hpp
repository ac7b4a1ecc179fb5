// SPDX-License-Identifier: Apache-2.0
// What the machine description says of a heater and what it heats: how fast it should get hot.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace thermal {

struct HeaterModel {
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

inline constexpr HeaterModel no_heater_model{};

// How fast the temperature changes, and would by the nominal heater. In mK/s.
struct Slopes {
  std::int32_t measured{};
  std::int32_t heating{};
  std::int32_t still{};  // lost in still air
  std::int32_t blown{};  // lost to the fan
  std::int32_t melted{};  // lost to the filament
};

// What cools the block that the heater's own loop does not know of.
struct Cooling {
  std::uint8_t fan{};  // of 255
  units::MicrometersPerSecond filament{};  // pushed into the hotend
};

}  // namespace thermal
