// SPDX-License-Identifier: Apache-2.0
// Pauses of a heater that heats up, in which its block cools down: a reading that falls faster than
// that of any described heater drifts.
#include "thermal/coast.hpp"

#include <algorithm>
#include <limits>

namespace thermal {
namespace {

// A heater that gets hot so fast pauses: mK/s.
constexpr std::int32_t least_rise = 1'000;
constexpr std::int32_t least_below = 10'000;
constexpr std::int32_t longest_wait = 64'000, longest_pause = 12'000, longest_update = 1'000;
// So long after a pause has begun the heat of before it, of which a firmware that has just
// started knows nothing, is no longer felt.
constexpr std::int32_t settling = 4'500;
// Felt heat in percent of full power: what counts as much, as little, and as none.
constexpr std::int32_t much = 80, little = 20, none = 12;
// Rooms are of 5 to 45 degrees. The most that a block loses, where it is colder than `coldest`, is
// what the model loses at `coldest`.
constexpr std::int32_t surroundings = 25'000, warmest_room = 45'000, coldest = 50'000;
// What is lost at such a temperature shows what is lost in more heat; it is looked for, half way.
constexpr std::int32_t least_known = 80'000, half_way = 100'000;
// What fan and filament take more may be so much more than described, in percent.
constexpr std::int32_t carried_tolerance = 60;
// An absolute part of the fall, in percent of the rise at full power, and what is borne in mK.
constexpr std::int32_t offset = 4, limit = 800;
// A slope that becomes less by so much of the rise, in percent, is suspicious.
constexpr std::int32_t suspicious_part = 14;
constexpr std::int32_t fast = 2, slow = 12;  // windows of the means
// A drift that is to be found: mK/s.
constexpr std::int32_t drift = 1'000;
// So much of the answer to the lost heat that the weakest heater gives, in percent, must show.
constexpr std::int32_t least_answer = 50;
constexpr std::int32_t part_scale = 256;

// The slope without losses: what heats by the sensor. mK/s.
std::int32_t warmed_by(const Slopes& slopes) {
  return slopes.measured + slopes.still + slopes.blown + slopes.melted;
}

}  // namespace

void Coast::restart() {
  begun_ = pausing_ = recovering_ = false;
  heated_ = heating_ = 0;
}

bool Coast::watches(std::int32_t below) const {
  return model_->rise >= least_rise && below >= least_below;
}

bool Coast::pause(const State& state) {
  const std::int32_t elapsed = std::min(state.milliseconds, longest_update);
  const bool starts = !begun_;
  begun_ = true;
  heated_ = state.full && !pausing_ ? std::min(heated_ + elapsed, longest_wait) : 0;
  if (state.held) wait_ = shortest_wait;
  if (pausing_) {
    paused_ += elapsed;
    pausing_ = paused_ < longest_pause;
  } else if (watches(state.below) && !state.held) {
    const bool is_hot_start = starts && lost_at_ == 0 && state.celsius > least_known;
    if (is_hot_start && !paused_at_start_) {
      paused_at_start_ = true;
      begin();
    } else if (is_due(state)) {
      begin();
    }
  }
  return pausing_;
}

bool Coast::is_due(const State& state) {
  if (heated_ < wait_) return false;
  if (!paused_in_heat_) {
    paused_in_heat_ = true;
    if (may_drift_) return true;
  }
  const bool is_loss_unknown = lost_at_ == 0 && state.celsius > half_way;
  if (!is_loss_unknown && !suspicious_) return false;
  wait_ = std::min(2 * wait_, longest_wait);
  return true;
}

void Coast::begin() {
  pausing_ = recovering_ = true;
  suspicious_ = false;
  paused_ = 0;
  excess_ = fallen_ = windows_ = 0;
  carried_least_ = std::numeric_limits<std::int32_t>::max();
}

bool Coast::add(const Window& window) {
  const Slopes& slopes = window.slopes;
  // The heat of before a pause is felt for a while.
  if (slopes.heating >= model_->rise * much / 100) {
    heating_ = slopes.heating;
    warmed_ = warmed_by(slopes);
  }
  if (!pausing_) {
    suspect(slopes);
    return false;
  }
  carried_least_ = std::min(carried_least_, slopes.blown + slopes.melted);
  if (paused_ < settling || slopes.heating > model_->rise * little / 100) return false;
  if (is_unanswered(slopes)) return true;
  if (slopes.heating > model_->rise * none / 100) return false;
  ++windows_;
  const std::int32_t fall = late_heat(slopes) - slopes.measured;
  const std::int32_t beyond = fall - most_fall(window);
  fallen_ += fall;
  excess_ = std::max<std::int32_t>(excess_ + beyond * window.milliseconds / 1'000, 0);
  if (excess_ > limit + window.noise / 4) return true;
  // One window is enough where nothing is learnt from it.
  if (excess_ == 0 && (window.celsius < least_known || windows_ > 1)) {
    pausing_ = false;
    slow_ = fast_;
    if (window.celsius >= least_known) learn(window, fall);
  }
  return false;
}

// What the model does not explain becomes less at once where a reading begins to drift, and changes
// slowly otherwise.
void Coast::suspect(const Slopes& slopes) {
  if (slopes.heating > model_->rise / 2) recovering_ = false;
  if (slopes.heating < model_->rise * much / 100) return;
  const std::int32_t unexplained = warmed_ - slopes.heating;
  if (!compared_) fast_ = slow_ = unexplained;
  compared_ = true;
  fast_ += (unexplained - fast_) / fast;
  slow_ += (unexplained - slow_) / slow;
  suspicious_ = slow_ - fast_ > model_->rise * suspicious_part / 100;
  // With a drift not even the strongest heater with the least losses would get hot so fast.
  const std::int32_t lost = warmed_ - slopes.measured;
  const std::int32_t least_lost =
      lost_at_ > 0 ? lost_ * 100 / (100 + model_->draught) : lost * model_->least_loss / 100;
  const std::int32_t measured = fast_ + heating_ - lost;
  may_drift_ = measured < heating_ * model_->most_power / 100 - least_lost - drift;
}

// mK/s that the heat of before the pause still brings, by the answer to the lack of the rest.
std::int32_t Coast::late_heat(const Slopes& slopes) const {
  if (heating_ == 0) return slopes.heating;
  const std::int32_t warmed = warmed_by(slopes);
  const std::int32_t part = slopes.heating * part_scale / (heating_ - slopes.heating);
  return std::clamp((warmed_ - warmed) * part / part_scale,
                    slopes.heating * model_->least_power / 100,
                    slopes.heating * model_->most_power / 100);
}

// A sensor that is frozen shows the same slope with the heat and without.
bool Coast::is_unanswered(const Slopes& slopes) const {
  if (heating_ == 0) return false;
  const std::int32_t warmed = warmed_by(slopes);
  const std::int32_t least = (heating_ - slopes.heating) * model_->least_power / 100;
  return warmed_ - warmed < least * least_answer / 100;
}

// mK/s: of the heater that loses most, in the most draught; or what this one has lost in a pause,
// and the draught, fan and filament of now in addition.
std::int32_t Coast::most_fall(const Window& window) const {
  const Slopes& slopes = window.slopes;
  const std::int32_t in_cold = (coldest - surroundings) / 16 * model_->loss / 62'500;
  const std::int32_t carried = slopes.blown + slopes.melted;
  const std::int32_t still = std::max(slopes.still, in_cold) * (100 + model_->draught) / 100;
  std::int32_t most = (still + carried) * model_->most_loss / 100;
  if (lost_at_ > 0) {
    const std::int32_t then = (lost_at_ - warmest_room) / 256;
    const std::int32_t now = std::max((window.celsius - warmest_room) / 256, then);
    const std::int32_t more_carried = std::max<std::int32_t>(carried - carried_, 0);
    most = std::min(most, lost_ * now / then * (100 + model_->draught) / 100 +
                              more_carried * (100 + carried_tolerance) / 100);
  }
  return most + model_->rise * offset / 100;
}

// The mean of the windows, since noise may hide much of the last; or the last, in which there is
// less heat from before a start.
void Coast::learn(const Window& window, std::int32_t fall) {
  if (lost_at_ == 0) wait_ = shortest_wait;
  carried_ = carried_least_;
  // In the warmest room it is more than half of what the model says.
  const std::int32_t least = (window.slopes.still / 2 + carried_) * model_->least_loss / 100;
  lost_ = std::max({fallen_ / windows_, fall, least});
  lost_at_ = window.celsius;
}

}  // namespace thermal
