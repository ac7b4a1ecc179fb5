// SPDX-License-Identifier: Apache-2.0
// A hotend or a heated bed: heat capacities, losses, and the lag until the sensor feels
// it. SI units.
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

void HeatedBlock::set_heater(double seconds, bool on) {
  if (on == on_) return;
  advance(seconds);
  on_ = on;
}

void HeatedBlock::set_supply(double seconds, bool closed) {
  if (closed == supplied_) return;
  advance(seconds);
  supplied_ = closed;
}

void HeatedBlock::set_fan(double seconds, double speed) {
  if (speed == fan_speed_) return;
  advance(seconds);
  fan_speed_ = speed;
  path_ = ThermalPath(properties_.path, loss());
}

void HeatedBlock::set_extrusion(double seconds, double cubic_mm_per_second) {
  if (cubic_mm_per_second == extrusion_) return;
  advance(seconds);
  extrusion_ = cubic_mm_per_second;
  path_ = ThermalPath(properties_.path, loss());
}

void HeatedBlock::set_fault(double seconds, HeaterFault fault) {
  advance(seconds);
  fault_ = fault;
}

void HeatedBlock::set_bead_fault(double seconds, BeadFault fault) {
  bead_kelvin_ = sensor_celsius(seconds) - ambient_celsius_;
  bead_fault_seconds_ = seconds;
  bead_fault_ = fault;
}

double HeatedBlock::celsius(double seconds) const {
  return ambient_celsius_ + state_at(seconds)[1];
}

double HeatedBlock::sensor_celsius(double seconds) const {
  const double since = seconds - bead_fault_seconds_;
  switch (bead_fault_) {
    case BeadFault::none:
      break;
    case BeadFault::frozen:
      return ambient_celsius_ + bead_kelvin_;
    case BeadFault::drifting:
      return ambient_celsius_ + state_at(seconds)[2] - drift_kelvin_per_second * since;
    case BeadFault::detached:
      return ambient_celsius_ + bead_kelvin_ * std::exp(-since / bead_in_air_seconds);
  }
  return ambient_celsius_ + state_at(seconds)[2];
}

double HeatedBlock::heater_joules(double seconds) const {
  return joules_ + watts() * (seconds - static_cast<double>(state_us_) / us_per_s);
}

double HeatedBlock::watts() const {
  const bool heats = fault_ == HeaterFault::stuck_on || (fault_ == HeaterFault::none && on_);
  return heats && supplied_ ? properties_.heater_watts : 0;
}

double HeatedBlock::loss() const {
  return properties_.loss_watts_per_kelvin + fan_speed_ * properties_.fan_loss_watts_per_kelvin +
         extrusion_ * plastic_joules_per_cubic_mm_kelvin;
}

HeatState HeatedBlock::state_at(double seconds) const {
  return path_.after(state_, std::llround(seconds * us_per_s) - state_us_, watts());
}

void HeatedBlock::advance(double seconds) {
  joules_ = heater_joules(seconds);
  state_ = state_at(seconds);
  state_us_ = std::llround(seconds * us_per_s);
}

}  // namespace plants
