// SPDX-License-Identifier: Apache-2.0
// What a machine description may say of its filament: where a sensor is, and how far it is loaded.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace application {

struct FilamentSensor {
  std::uint8_t input{};  // of the end stops, 0 .. 7
  bool low_is_out{};  // the pin's level without filament
};

// To and from the nozzle.
struct FilamentChange {
  static constexpr units::Nanometers longest{2'000'000'000};

  units::Nanometers load{};  // M603 L
  units::Nanometers unload{};  // M603 U
  units::MicrometersPerSecond load_speed{};
  units::MicrometersPerSecond unload_speed{};
  units::Nanometers purge{};  // out of the nozzle, when it is loaded
  units::MicrometersPerSecond purge_speed{};
};

}  // namespace application
