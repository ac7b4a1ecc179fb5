// SPDX-License-Identifier: Apache-2.0
// The faults of heaters and sensors, each with its name.
#pragma once

#include <cstdint>
#include <string_view>

namespace thermal {

enum class Fault : std::uint8_t {
  sensor_open,  // thermistor or its wire is broken
  sensor_short,  // thermistor or its wires are shorted
  sensor_stuck,  // the pin reads 1 with an empty capacitor
  sensor_time_out,  // the capacitor does not charge through any resistor
  sensor_stale,  // no conversion for too long
  sensor_frozen,  // a small change of the heat does not show
  sensor_implausible,  // the references or the temperature cannot be true
  min_temperature,  // colder than the machine can be
  max_temperature,  // hotter than the machine may be
  heating_failed,  // the heater is on, the temperature does not rise
  thermal_runaway,  // the temperature was reached and then lost
  unasked_heat,  // the heater is off, the temperature rises
  cut_off  // the hardware has closed the gate
};

// For messages to the host, in the words that Marlin's users know where it has them.
constexpr std::string_view name_of(Fault fault) {
  switch (fault) {
    case Fault::sensor_open:
      return "thermistor open";
    case Fault::sensor_short:
      return "thermistor shorted";
    case Fault::sensor_stuck:
      return "sensor pin stuck";
    case Fault::sensor_time_out:
      return "sensor does not charge";
    case Fault::sensor_stale:
      return "sensor silent";
    case Fault::sensor_frozen:
      return "thermistor frozen";
    case Fault::sensor_implausible:
      return "sensor implausible";
    case Fault::min_temperature:
      return "MINTEMP triggered";
    case Fault::max_temperature:
      return "MAXTEMP triggered";
    case Fault::heating_failed:
      return "Heating failed";
    case Fault::thermal_runaway:
      return "Thermal Runaway";
    case Fault::unasked_heat:
      return "heats while off";
    case Fault::cut_off:
      return "heater cut off by the hardware";
  }
  return "unknown thermal fault";
}

}  // namespace thermal
