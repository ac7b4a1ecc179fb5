// SPDX-License-Identifier: Apache-2.0
// An NTC thermistor: resistance by temperature.
#pragma once

#include <cmath>

namespace plants {

struct Thermistor {
  double resistance_25c_ohms{};
  double beta_kelvin{};

  // The beta formula (IEC 60539-1).
  double ohms(double celsius) const {
    constexpr double zero_celsius_k = 273.15;
    constexpr double reference_k = 25.0 + zero_celsius_k;
    return resistance_25c_ohms *
           std::exp(beta_kelvin * (1.0 / (celsius + zero_celsius_k) - 1.0 / reference_k));
  }
};

}  // namespace plants
