// SPDX-License-Identifier: Apache-2.0
// A heater by the machine description: how fast it should get hot, and what its watch needs.
#pragma once

#include <cstdint>

#include "thermal/heater_grid.hpp"
#include "thermal/heater_properties.hpp"
#include "thermal/rhythm.hpp"
#include "units/quantity.hpp"

namespace thermal {

// With what the compiler makes of it, for the machine's description is constant.
struct HeaterModel : HeaterProperties {
  constexpr explicit HeaterModel(const HeaterProperties& properties = {})
      : HeaterProperties(properties), rhythm(rhythm_of(properties)), grid(grid_of(properties)) {}

  Rhythm rhythm;
  HeaterGrid grid;
};

inline constexpr HeaterModel no_heater_model{};

// How fast the temperature changes, and would by the nominal heater. In mK/s.
struct Slopes {
  std::int32_t measured{};
  std::int32_t heating{};
  std::int32_t still{};  // lost in still air
  std::int32_t blown{};  // lost to the fan
  std::int32_t melted{};  // lost to the filament
};

// What cools the block that the heater's own loop does not know of.
struct Cooling {
  std::uint8_t fan{};  // of 255
  units::MicrometersPerSecond filament{};  // pushed into the hotend
};

}  // namespace thermal
