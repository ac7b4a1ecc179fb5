// SPDX-License-Identifier: Apache-2.0
// The heat that a held temperature needs, compared with what it needed a little earlier.
#include "thermal/demand.hpp"

#include <algorithm>
#include <cstdlib>

#include "units/loop_bound.hpp"

namespace thermal {
namespace {

// A supply that falls to so much of what it was, in percent.
constexpr std::int32_t least_supply = 80;
// What fan and filament take more may be so many times as much as described.
constexpr std::int32_t most_carried = 2;
// The lags may be so much longer or shorter, in percent.
constexpr std::int32_t lag_tolerance = 50;
// A block that has become warmer loses more; how much depends on the room, too. In percent of the
// growth by the model.
constexpr std::int32_t most_growth = 125;
// Of a quotient, so that no product of sums exceeds 31 bits.
constexpr std::int32_t growth_scale = 256;

}  // namespace

void Demand::restart() {
  sum_ = {};
  milliseconds_ = 0;
  seen_ = 0;
  pairs_seen_ = 0;
}

bool Demand::add(const Slopes& slopes, std::int32_t milliseconds) {
  const auto in_window = [milliseconds](std::int32_t slope) {
    return slope * milliseconds / 1'000;
  };
  const std::int32_t first = milliseconds_ == 0 ? slopes.heating : sum_.first;
  sum_ = both(sum_, {in_window(slopes.heating), in_window(slopes.measured), in_window(slopes.still),
                     in_window(slopes.blown + slopes.melted), slopes.heating, slopes.heating});
  sum_.first = first;
  milliseconds_ += milliseconds;
  if (milliseconds_ < span_) return false;
  std::shift_left(spans_.begin(), spans_.end(), 1);
  spans_.back() = sum_;
  sum_ = {};
  milliseconds_ = 0;
  seen_ = std::min(seen_ + 1, length);
  find_pairs();
  return true;
}

// What may be on its way to the sensor, or have come from it, otherwise than by the model.
std::int32_t Demand::stored(const Span& span) const {
  const auto lag = static_cast<std::int32_t>((model_->heater_lag + model_->sensor_lag).count());
  return std::abs(span.last - span.first) * lag / 1'000 * lag_tolerance / 100;
}

// What does not depend on the power: a division takes the processor 18 clocks, and there are many.
void Demand::find_pairs() {
  pairs_seen_ = 0;
  // Two spans against two: one is too short for the noise.
  if (seen_ < 4) return;
  const Span now = both(spans_[length - 2], spans_[length - 1]);
  least_heating_ = now.heating - stored(now);
  measured_ = now.measured;
  units::LoopBound<length> bound;
  for (std::size_t i = length - seen_; i + 3 < length; ++i) {
    bound.next();
    const Span before = both(spans_[i], spans_[i + 1]);
    // Of a block that was much colder too little is known.
    if (before.still < now.still / 2 || before.still <= 0) continue;
    const std::int32_t warmer = std::max<std::int32_t>(now.still - before.still, 0);
    const std::int32_t more_carried = std::max<std::int32_t>(now.carried - before.carried, 0);
    pairs_[pairs_seen_++] = {
        .most_heating = before.heating + stored(before),
        .measured = before.measured,
        .more_lost = growth_scale + warmer * growth_scale / before.still * most_growth / 100,
        .more_carried = most_carried * more_carried};
  }
}

bool Demand::has_grown(const Power& power) const {
  const std::int32_t least_heat = least_heating_ * power.least / Power::scale;
  const std::int32_t explained =
      (least_heat * least_supply / 100 - measured_) * 100 / (100 + model_->draught);
  units::LoopBound<length> bound;
  for (std::size_t i = 0; i < pairs_seen_; ++i) {
    bound.next();
    const Pair& before = pairs_[i];
    const std::int32_t most_before =
        before.most_heating * power.most / Power::scale - before.measured;
    if (explained > std::max<std::int32_t>(most_before, 0) * before.more_lost / growth_scale +
                        before.more_carried) {
      return true;
    }
  }
  return false;
}

}  // namespace thermal
