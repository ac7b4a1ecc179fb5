// SPDX-License-Identifier: Apache-2.0
// A hotend or a heated bed: heat capacities, losses, and the lag until the sensor feels
// it. SI units.
#pragma once

#include <cstdint>

#include "sim/plants/thermal_path.hpp"

namespace plants {

struct HeatedBlockProperties {
  double heater_watts{};
  ThermalPathProperties path;
  double loss_watts_per_kelvin{};  // to the surroundings, in still air
  double fan_loss_watts_per_kelvin{};  // in addition, with the fan at full speed
};

enum class HeaterFault : std::uint8_t { none, stuck_on, stuck_off };

// The temperature at the thermistor's bead instead of the block's, from the time of the fault on.
enum class BeadFault : std::uint8_t {
  none,
  frozen,  // stays as warm as it was
  drifting,  // ever colder than the block, by drift_kelvin_per_second
  detached  // hangs in still air and cools down to the surroundings
};

// Times are in seconds since the start and never go back. Reading a temperature changes nothing, so
// the course does not depend on how often it is read.
class HeatedBlock {
 public:
  static constexpr double drift_kelvin_per_second = 1.0;
  static constexpr double bead_in_air_seconds = 10.0;  // time constant of a small glass bead

  HeatedBlock(const HeatedBlockProperties& properties, double ambient_celsius,
              double start_celsius);

  void set_heater(double seconds, bool on);
  // The power behind the transistor, closed at first; without it nothing heats, whatever the
  // transistor does.
  void set_supply(double seconds, bool closed);
  // 0 to 1.
  void set_fan(double seconds, double speed);
  // Plastic that comes in cold and leaves hot.
  void set_extrusion(double seconds, double cubic_mm_per_second);
  // The state of the transistor from now on, regardless of its gate.
  void set_fault(double seconds, HeaterFault fault);
  void set_bead_fault(double seconds, BeadFault fault);

  double celsius(double seconds) const;  // of the block: what the plastic feels
  double sensor_celsius(double seconds) const;  // of the thermistor's bead
  double heater_joules(double seconds) const;  // given off by the heater since the start

 private:
  double watts() const;
  double loss() const;
  HeatState state_at(double seconds) const;
  void advance(double seconds);

  HeatedBlockProperties properties_;
  double ambient_celsius_;
  HeatState state_;
  std::int64_t state_us_ = 0;  // the time of state_
  double joules_ = 0;  // until then
  bool on_ = false;
  bool supplied_ = true;
  HeaterFault fault_ = HeaterFault::none;
  BeadFault bead_fault_ = BeadFault::none;
  double bead_fault_seconds_ = 0;
  double bead_kelvin_ = 0;  // at that time, above the surroundings
  double fan_speed_ = 0;
  double extrusion_ = 0;
  ThermalPath path_;
};

}  // namespace plants
