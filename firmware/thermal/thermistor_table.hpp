// SPDX-License-Identifier: Apache-2.0
// The curve of an NTC thermistor as a table that the compiler makes, read by linear interpolation.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "thermal/elementary_functions.hpp"
#include "units/loop_bound.hpp"
#include "units/quantity.hpp"

namespace thermal {

struct NtcProperties {
  units::Milliohms resistance_25c{};
  std::int32_t beta_kelvin{};
};

// The beta formula, R = R25 exp(B (1/T - 1/T25)), with T in kelvin (IEC 60539-1, B value).
consteval double ntc_ohms(const NtcProperties& ntc, double celsius) {
  constexpr double zero_celsius_k = 273.15;
  constexpr double reference_k = 25.0 + zero_celsius_k;
  return static_cast<double>(ntc.resistance_25c.count()) / 1000.0 *
         exponential(ntc.beta_kelvin * (1.0 / (celsius + zero_celsius_k) - 1.0 / reference_k));
}

class ThermistorTable {
 public:
  static constexpr units::Millicelsius lowest{-10'000};
  static constexpr units::Millicelsius highest{300'000};
  static constexpr units::Millicelsius step{2'500};
  static constexpr std::size_t size =
      static_cast<std::size_t>((highest - lowest).count() / step.count()) + 1;

  consteval explicit ThermistorTable(const NtcProperties& ntc) {
    for (std::size_t i = 0; i < size; ++i) {
      milliohms_[i] =
          static_cast<std::uint32_t>(ntc_ohms(ntc, point(i).count() / 1000.0) * 1000.0 + 0.5);
    }
  }

  // Nothing where the temperature would lie outside lowest to highest. Within, the error against
  // the beta formula is below 0.06 degrees for the usual B (proved in thermistor_table.cpp).
  constexpr std::optional<units::Millicelsius> temperature(units::Milliohms resistance) const {
    if (resistance.count() > milliohms_.front() || resistance.count() < milliohms_.back()) {
      return {};
    }
    const auto value = static_cast<std::uint32_t>(resistance.count());
    // The first point that is at least as hot: resistance falls along the table.
    std::size_t index = 1;
    units::LoopBound<std::bit_width(size - 2)> halves;
    for (std::size_t count = size - 2; count > 0;) {
      halves.next();
      const std::size_t half = count / 2;
      if (milliohms_[index + half] > value) {
        index += half + 1;
        count -= half + 1;
      } else {
        count = half;
      }
    }
    const std::int64_t span = milliohms_[index - 1] - milliohms_[index];
    const std::int64_t part = milliohms_[index - 1] - value;
    return point(index - 1) +
           units::Millicelsius(static_cast<std::int32_t>((part * step.count() + span / 2) / span));
  }

  // The inverse, by the same interpolation; beyond the ends the resistance of the end.
  constexpr units::Milliohms resistance(units::Millicelsius temperature) const {
    const std::int32_t offset = std::clamp(temperature, lowest, highest).count() - lowest.count();
    const auto index = std::min(static_cast<std::size_t>(offset / step.count()), size - 2);
    const std::int64_t part = offset - static_cast<std::int32_t>(index) * step.count();
    const std::int64_t span = milliohms_[index] - milliohms_[index + 1];
    return units::Milliohms(milliohms_[index] - span * part / step.count());
  }

 private:
  static constexpr units::Millicelsius point(std::size_t index) {
    return lowest + step * static_cast<std::int32_t>(index);
  }

  std::array<std::uint32_t, size> milliohms_{};
};

}  // namespace thermal
