// SPDX-License-Identifier: Apache-2.0
// Heaters within the tolerances of a description: parts of the nominal power and of the nominal
// losses. Found by the compiler, for each takes divisions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "thermal/heater_properties.hpp"

namespace thermal {

// With nearly equal ratios from one to the next. 10 fractional bits.
struct HeaterGrid {
  static constexpr int steps = 9;  // of power, and of losses
  static constexpr std::int32_t nominal = 1'024;

  std::array<std::int16_t, 2 * steps - 1> half_powers{};  // those of the grid, and halfway between
  std::array<std::int16_t, steps> losses{};

  constexpr std::int32_t power(int step) const { return halfway(2 * step); }
  // In half steps; of the first or last one beyond them.
  constexpr std::int32_t halfway(int half_step) const {
    const int last = 2 * steps - 2;
    return half_powers[static_cast<std::size_t>(half_step < 0      ? 0
                                                : half_step > last ? last
                                                                   : half_step)];
  }
  constexpr std::int32_t loss(int step) const { return losses[static_cast<std::size_t>(step)]; }
};

// Part of the nominal value at one of `last` + 1 steps from `least` to `most` percent: the mean of
// arithmetic and harmonic steps.
constexpr std::int32_t grid_part(std::int32_t least, std::int32_t most, int step, int last) {
  const std::int32_t arithmetic =
      (least * (last - step) + most * step) * HeaterGrid::nominal / (last * 100);
  const std::int32_t harmonic =
      least * most / 100 * last * HeaterGrid::nominal / (most * (last - step) + least * step);
  return (arithmetic + harmonic) / 2;
}
static_assert(grid_part(50, 200, 0, 2) == 512 && grid_part(50, 200, 2, 2) == 2'048);
static_assert(grid_part(50, 200, 1, 2) == (1'280 + 819) / 2);

constexpr HeaterGrid grid_of(const HeaterProperties& heater) {
  HeaterGrid grid;
  const auto fill = [](auto& parts, std::int32_t least, std::int32_t most) {
    const auto last = static_cast<int>(parts.size()) - 1;
    for (int i = 0; i <= last; ++i) {
      parts[static_cast<std::size_t>(i)] =
          static_cast<std::int16_t>(grid_part(least, most, i, last));
    }
  };
  fill(grid.half_powers, heater.least_power, heater.most_power);
  fill(grid.losses, heater.least_loss, heater.most_loss);
  return grid;
}

}  // namespace thermal
