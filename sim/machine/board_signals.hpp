// SPDX-License-Identifier: Apache-2.0
// What the boards' constraints require at the chip's pins: the simulated board has the same.
#pragma once

#include <string_view>

#include "sim/devices/thermistor_input.hpp"

namespace machine {

// The pull of a signal of constraints/signals.csv. Throws std::out_of_range where it has none of
// this name.
devices::Pull pull_of(std::string_view signal);

// Those of the sensor pins.
devices::SensorPulls sensor_pulls();

}  // namespace machine
