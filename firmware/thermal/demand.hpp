// SPDX-License-Identifier: Apache-2.0
// The heat that a held temperature needs, compared with what it needed a little earlier: it grows
// with draught, fan and filament, but not without end.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "thermal/heater_model.hpp"

namespace thermal {

// needed = power * heating - slope, over two spans of time. How much the heater at hand loses
// does not matter, so a few seconds of a hold are enough to compare with.
class Demand {
 public:
  // Parts of the nominal power between which the heater's lies.
  struct Power {
    static constexpr std::int32_t scale = HeaterGrid::nominal;
    std::int32_t least, most;
  };

  // The model must outlive it.
  explicit constexpr Demand(const HeaterModel& model) : model_(&model), span_(span_of(model)) {}

  // With each window of the comparison, while one target is wanted: true if there is more to judge.
  bool add(const Slopes& slopes, std::int32_t milliseconds);
  // Another target, or none.
  void restart();
  // A heater of this power has needed so little at some time of the last spans that draught, a
  // weaker supply and what is known of fan and filament do not explain what it needs now.
  bool has_grown(const Power& power) const;

 private:
  static constexpr std::size_t length = 12;  // spans that are compared

  // Sums, in mK; the heating at both ends, in mK/s.
  struct Span {
    std::int32_t heating{};
    std::int32_t measured{};
    std::int32_t still{};  // lost in still air
    std::int32_t carried{};  // lost to fan and filament
    std::int32_t first{}, last{};
  };
  // So long that the rhythm of the probe and the noise count for little.
  static constexpr std::int32_t span_of(const HeaterModel& model) {
    return static_cast<std::int32_t>((model.heater_lag + model.sensor_lag).count() * 3 / 2);
  }
  static Span both(const Span& one, const Span& other) {
    return {one.heating + other.heating,
            one.measured + other.measured,
            one.still + other.still,
            one.carried + other.carried,
            one.first,
            other.last};
  }
  std::int32_t stored(const Span& span) const;
  void find_pairs();

  // Two spans that the last two are compared with.
  struct Pair {
    std::int32_t most_heating{};  // as below, at most
    std::int32_t measured{};
    std::int32_t more_lost{};  // so many times as much since then, with 8 fractional bits
    std::int32_t more_carried{};  // to fan and filament, in mK
  };

  const HeaterModel* model_;
  std::int32_t span_;  // ms
  Span sum_{};  // of the span under way
  std::int32_t milliseconds_ = 0;  // in it
  std::size_t seen_ = 0;  // spans, at most `length`
  std::array<Span, length> spans_{};
  std::int32_t least_heating_ = 0, measured_ = 0;  // of the last two, in mK
  std::array<Pair, length> pairs_{};
  std::size_t pairs_seen_ = 0;
};

}  // namespace thermal
