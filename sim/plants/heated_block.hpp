// SPDX-License-Identifier: Apache-2.0
// A hotend or a heated bed: heat capacities, losses, and the lag until the sensor feels it. SI
// units.
#pragma once

#include <cstdint>

#include "sim/plants/thermal_path.hpp"

namespace plants {

struct HeatedBlockProperties {
  ThermalPathProperties path;
  double loss_watts_per_kelvin{};  // to the surroundings, in still air
  double fan_loss_watts_per_kelvin{};  // in addition, with the fan at full speed
};

class HeatedBlock {
 public:
  HeatedBlock(const HeatedBlockProperties& properties, double ambient_celsius,
              double start_celsius);

  // Time passes with this power in the heater, however long: many short times and one long time
  // that they add up to lead to the same temperatures.
  void heat(double seconds, double watts);
  // From now on; 0 to 1.
  void set_fan(double speed);
  // Plastic that comes in cold and leaves hot, from now on.
  void set_extrusion(double cubic_mm_per_second);

  double celsius() const {
    return ambient_celsius_ + state_[1];
  }  // of the block: what the plastic feels
  double sensor_celsius() const {
    return ambient_celsius_ + state_[2];
  }  // of the thermistor's bead
  double seconds() const { return seconds_; }  // since the start
  double heater_joules() const { return heater_joules_; }  // since the start

 private:
  double loss() const;

  HeatedBlockProperties properties_;
  double ambient_celsius_;
  HeatState state_;
  double seconds_ = 0;
  std::int64_t state_us_ = 0;  // the time of state_: seconds_ in whole microseconds
  double heater_joules_ = 0;
  double fan_speed_ = 0;
  double extrusion_ = 0;
  ThermalPath path_;
};

}  // namespace plants
