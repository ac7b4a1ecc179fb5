// SPDX-License-Identifier: Apache-2.0
// The drivers of one chip, and its identity.
#pragma once

#include "drivers/end_stops.hpp"
#include "drivers/fan.hpp"
#include "drivers/heater_control.hpp"
#include "drivers/identity.hpp"
#include "drivers/step_generator.hpp"
#include "drivers/temperature_converter.hpp"
#include "drivers/timer.hpp"
#include "drivers/uart.hpp"

namespace application {

struct Hardware {
  explicit Hardware(const drivers::Identity& chip)
      : identity(chip), temperature_converter(chip.clock), heater_control(chip.clock) {}

  drivers::Identity identity;
  drivers::Uart uart;
  drivers::Timer timer;
  drivers::StepGenerator step_generator;
  drivers::EndStops end_stops;
  drivers::TemperatureConverter temperature_converter;
  drivers::HeaterControl heater_control;
  drivers::Fan fan;
};

}  // namespace application
