// SPDX-License-Identifier: Apache-2.0
// The lags of heater and sensor, in integers.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace thermal {

// Of the duty on its way: fractional bits, so that a slow filter does not lose what it is given.
inline constexpr std::int32_t duty_scale = 16;

// `elapsed` in ms.
constexpr std::int32_t low_pass(std::int32_t state, std::int32_t input, units::Milliseconds lag,
                                std::int32_t elapsed) {
  return state + (input - state) * elapsed / (static_cast<std::int32_t>(lag.count()) + elapsed);
}

}  // namespace thermal
