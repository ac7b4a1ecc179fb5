// SPDX-License-Identifier: Apache-2.0
// A hotend or a heated bed: heat capacities, losses, and the lag until the sensor feels it. SI
// units.
#include "sim/plants/heated_block.hpp"

#include <cmath>

namespace plants {
namespace {

// PLA: 1.24 g/cm^3 and about 1.9 J/(g K) between room and melt.
constexpr double plastic_joules_per_cubic_mm_kelvin = 1.24e-3 * 1.9;

constexpr double us_per_s = 1e6;

}  // namespace

HeatedBlock::HeatedBlock(const HeatedBlockProperties& properties, double ambient_celsius,
                         double start_celsius)
    : properties_(properties),
      ambient_celsius_(ambient_celsius),
      path_(properties.path, properties.loss_watts_per_kelvin) {
  state_.fill(start_celsius - ambient_celsius);
}

void HeatedBlock::heat(double seconds, double watts) {
  seconds_ += seconds;
  heater_joules_ += watts * seconds;
  const std::int64_t now_us = std::llround(seconds_ * us_per_s);
  state_ = path_.after(state_, now_us - state_us_, watts);
  state_us_ = now_us;
}

void HeatedBlock::set_fan(double speed) {
  if (speed == fan_speed_) return;
  fan_speed_ = speed;
  path_ = ThermalPath(properties_.path, loss());
}

void HeatedBlock::set_extrusion(double cubic_mm_per_second) {
  if (cubic_mm_per_second == extrusion_) return;
  extrusion_ = cubic_mm_per_second;
  path_ = ThermalPath(properties_.path, loss());
}

double HeatedBlock::loss() const {
  return properties_.loss_watts_per_kelvin + fan_speed_ * properties_.fan_loss_watts_per_kelvin +
         extrusion_ * plastic_joules_per_cubic_mm_kelvin;
}

}  // namespace plants
