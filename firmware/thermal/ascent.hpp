// SPDX-License-Identifier: Apache-2.0
// How fast a heater with much of its power on must get hotter, whichever described one it is: a
// reading that does not follow is of a sensor that froze, drifts or has fallen out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "thermal/heater_model.hpp"

namespace thermal {

// The power of the heater at hand lies above that of the weakest one described, and what it has
// once shown at full power, a falling supply apart. From it goes what a heater of such a loss can
// lose at most. Both are looked at for each loss of the grid, and the slowest ascent counts.
class Ascent {
 public:
  // The model must outlive it.
  explicit constexpr Ascent(const HeaterModel& model)
      : model_(&model),
        lags_(static_cast<std::int32_t>((model.heater_lag + model.sensor_lag).count())) {}

  // The middle of a window of the comparison. `needed`: mK/s that the nominal heater must have to
  // hold the target. `noise`: from end to end, in mK.
  struct Window {
    Slopes slopes;
    std::int32_t needed{};
    std::int32_t below{};  // the target, in mK
    bool reached{};  // the target, since it is wanted
    bool recovers{};  // from a pause of the heat
    std::int32_t noise{};
    std::int32_t milliseconds{};
  };

  enum class Finding : std::uint8_t { none, behind, ahead };
  // With each window while a temperature is wanted.
  Finding add(const Window& window);
  // No temperature is wanted, or there is none.
  void restart();
  // Another heater may be mounted.
  void forget() { shown_.fill(0); }

 private:
  static constexpr auto steps = static_cast<std::size_t>(HeaterGrid::steps);

  void learn(const Window& window);
  std::int32_t least_slope(const Window& window) const;
  bool stands_still(const Window& window, std::int32_t least);

  const HeaterModel* model_;
  std::int32_t lags_;  // ms
  // By loss: mK/s that the heater has shown at full power.
  std::array<std::int32_t, steps> shown_{};
  // Of the span under way, in which the heater is at full power: mK, and ms.
  std::int32_t measured_ = 0, learnt_milliseconds_ = 0;
  // Sums, in mK: of what is missing from a part of the ascent, and of what is beyond the
  // strongest heater.
  std::int32_t missing_ = 0, surplus_ = 0;
  // Since the reading last moved with much heat: mK, and ms.
  std::int32_t moved_ = 0, still_milliseconds_ = 0;
};

}  // namespace thermal
