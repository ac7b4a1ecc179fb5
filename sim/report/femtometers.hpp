// SPDX-License-Identifier: Apache-2.0
// Lengths without rounding error.
#pragma once

namespace report {

// A billionth of a millimetre, of an inch, and percents of both are whole numbers of femtometres.
__extension__ using Femtometers = __int128;
inline constexpr Femtometers femtometers_per_mm = 1'000'000'000'000;

constexpr double millimeters(Femtometers length) {
  return static_cast<double>(length) / static_cast<double>(femtometers_per_mm);
}

}  // namespace report
