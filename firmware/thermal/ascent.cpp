// SPDX-License-Identifier: Apache-2.0
// How fast a heater with much of its power on must get hotter, whichever described one it is.
#include "thermal/ascent.hpp"

#include <algorithm>
#include <cstdlib>

namespace thermal {
namespace {

// Of full power, in percent: what counts as all of it, as enough for a reading to move at all, and
// for it to rise.
constexpr std::int32_t full = 97, much = 80, half = 50;
// A supply that falls to so much of what it was, in percent.
constexpr std::int32_t least_supply = 80;
// What fan and filament take may be so much more or less than described, in percent.
constexpr std::int32_t carried_tolerance = 30;
// An absolute part, in percent of the rise at full power, of a slope.
constexpr std::int32_t offset = 2;
// Heaters beyond the described ones are borne: so much of the strongest, in percent.
constexpr std::int32_t strongest_part = 110, surplus_part = 145;
// Parts of the least ascent, in percent, and the limits of what may be missing from them, in
// percent of what full power brings within both lags.
constexpr std::int32_t missing_part = 55, missing_limit = 13;
constexpr std::int32_t surplus_limit = 60;
// A reading that moves by less than this part of it, in percent, for so long, with much heat.
constexpr std::int32_t still_limit = 5;
constexpr std::int32_t still_milliseconds = 14'500, still_below = 1'500;
// Noise above this part of it, in percent, hides what the heater shows.
constexpr std::int32_t most_noise = 33;

}  // namespace

void Ascent::restart() {
  measured_ = learnt_milliseconds_ = 0;
  missing_ = surplus_ = 0;
  moved_ = still_milliseconds_ = 0;
}

// Over a span as long as the lags, so that noise counts for little.
void Ascent::learn(const Window& window) {
  const Slopes& slopes = window.slopes;
  const std::int32_t in_lags = model_->rise * lags_ / 1'000;
  if (slopes.heating < model_->rise * full / 100 || window.noise > in_lags * most_noise / 100) {
    measured_ = learnt_milliseconds_ = 0;
    return;
  }
  measured_ += slopes.measured * window.milliseconds / 1'000;
  learnt_milliseconds_ += window.milliseconds;
  if (learnt_milliseconds_ < lags_) return;
  const std::int32_t slope = measured_ * 1'000 / learnt_milliseconds_;
  const std::int32_t lost =
      slopes.still + (slopes.blown + slopes.melted) * (100 - carried_tolerance) / 100;
  const std::int32_t strongest = model_->rise * model_->most_power / 100 * strongest_part / 100;
  for (std::size_t i = 0; i < steps; ++i) {
    const std::int32_t part = model_->grid.losses[i];
    const std::int32_t shown = slope + lost * part / HeaterGrid::nominal;
    shown_[i] = std::clamp(shown, shown_[i], std::max(shown_[i], strongest));
  }
  measured_ = learnt_milliseconds_ = 0;
}

std::int32_t Ascent::least_slope(const Window& window) const {
  const Slopes& slopes = window.slopes;
  const std::int32_t weakest = model_->rise * model_->least_power / 100;
  const std::int32_t lost = slopes.still * (100 + model_->draught) / 100 +
                            (slopes.blown + slopes.melted) * (100 + carried_tolerance) / 100;
  const std::int32_t part_of_full = slopes.heating * HeaterGrid::nominal / model_->rise;
  std::int32_t least = model_->rise;
  for (std::size_t i = 0; i < steps; ++i) {
    const std::int32_t part = model_->grid.losses[i];
    std::int32_t needed = window.needed * part / HeaterGrid::nominal;
    // The nominal heater counts as one that holds the target.
    if (part <= HeaterGrid::nominal) needed = std::min(needed, model_->rise);
    const std::int32_t power =
        std::max({weakest, needed, shown_[i] * least_supply / 100}) * part_of_full;
    least = std::min(least, (power - lost * part) / HeaterGrid::nominal);
  }
  return least - model_->rise * offset / 100;
}

bool Ascent::stands_still(const Window& window, std::int32_t in_window) {
  moved_ += in_window;
  still_milliseconds_ += window.milliseconds;
  const std::int32_t limit = model_->rise * lags_ / 1'000 * still_limit / 100;
  if (window.reached || window.below < still_below ||
      window.slopes.heating < model_->rise * much / 100 || std::abs(moved_) > limit) {
    moved_ = still_milliseconds_ = 0;
  }
  return still_milliseconds_ > still_milliseconds;
}

Ascent::Finding Ascent::add(const Window& window) {
  learn(window);
  const auto in_window = [&window](std::int32_t slope) {
    return slope * window.milliseconds / 1'000;
  };
  const std::int32_t least = in_window(least_slope(window));
  const std::int32_t measured = in_window(window.slopes.measured);
  const std::int32_t strongest =
      in_window(model_->rise * model_->most_power / 100 * surplus_part / 100);
  const std::int32_t in_lags = model_->rise * lags_ / 1'000;
  const auto exceeds = [in_lags, &window](std::int32_t& sum, std::int32_t change,
                                          std::int32_t percent) {
    const std::int32_t limit = in_lags * percent / 100 + window.noise / 4;
    sum = std::clamp<std::int32_t>(sum + change, 0, 2 * limit);
    return sum > limit;
  };
  const bool still = stands_still(window, measured);
  if (exceeds(surplus_, measured - strongest, surplus_limit)) return Finding::ahead;
  if (least <= 0 || window.slopes.heating < model_->rise * half / 100) {
    if (!window.recovers) missing_ = 0;
  } else if (exceeds(missing_, least * missing_part / 100 - measured, missing_limit)) {
    return Finding::behind;
  }
  return still ? Finding::behind : Finding::none;
}

}  // namespace thermal
