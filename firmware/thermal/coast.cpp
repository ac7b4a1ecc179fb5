// SPDX-License-Identifier: Apache-2.0
// Pauses of a heater, in which its block cools down: a reading that falls too fast drifts.
#include "thermal/coast.hpp"

#include <algorithm>
#include <cstdlib>
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
constexpr std::int32_t carried_tolerance = 60, least_carried = 60;
// An absolute part of the fall, in percent of the rise at full power, and what is borne in mK.
constexpr std::int32_t offset = 4, limit = 800;
// Windows of the means, and of one that a doubt slows down.
constexpr std::int32_t fast = 2, slow = 12, doubted = 96;
// A drift that is to be found: mK/s.
constexpr std::int32_t drift = 1'000;
// So much of the answer to the lost heat that the weakest heater gives, in percent, must show.
constexpr std::int32_t least_answer = 50;
constexpr std::int32_t part_scale = 256;
// Heat of so much of full power, in percent, shows the power of a heater whose loss is known, in so
// many windows.
constexpr std::int32_t showing = 30, showing_windows = 8;
// More heat than a moment ago is a cause to pause: beyond what draught, fan and filament may take,
// an absolute part in percent of the rise, and in a hold a supply that is so much lower, in
// percent. The limit is in mK.
constexpr std::int32_t doubted_offset = 2, doubted_sag = 7, doubt_limit = 1'500;
// Of what was lost in the last pause, in percent, what is lost at least.
constexpr std::int32_t known_part = 90;
// For the tolerance of the lags, in percent: what is not known from a pause before.
constexpr std::int32_t first_part = 115;
// A reading that changes by no more, in mK/s, for so many windows is one of a hold.
constexpr std::int32_t calm = 250, calm_after = 4;
// At its turn a reading seems to stand still, for its middle one of three counts. In ms.
constexpr std::int32_t longest_turn = 9'000;

// The slope without losses: what heats by the sensor. mK/s.
std::int32_t warmed_by(const Slopes& slopes) {
  return slopes.measured + slopes.still + slopes.blown + slopes.melted;
}

}  // namespace

void Coast::restart() {
  begun_ = pausing_ = recovering_ = false;
  heated_ = heating_ = since_pause_ = doubt_ = calm_windows_ = 0;
  doubts_ = held_ = is_referenced_ = false;
}

bool Coast::watches(std::int32_t below) const {
  return model_->rise >= least_rise && below >= least_below;
}

bool Coast::pause(const State& state) {
  const std::int32_t elapsed = std::min(state.milliseconds, longest_update);
  const bool starts = !begun_;
  begun_ = true;
  heated_ = state.full && !pausing_ ? std::min(heated_ + elapsed, longest_wait) : 0;
  since_pause_ = pausing_ ? 0 : std::min(since_pause_ + elapsed, longest_wait);
  if (state.held && !held_) wait_ = shortest_wait;
  held_ = state.held;
  coldest_seen_ = std::min(coldest_seen_, state.celsius);
  if (pausing_) {
    paused_ += elapsed;
    pausing_ = paused_ < longest_pause;
  } else if (doubts_ && since_pause_ >= wait_) {
    wait_ = std::min(2 * wait_, longest_wait);
    begin();
  } else if (watches(state.below) && !held_) {
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
  return lost_at_ == 0 && state.celsius > half_way;
}

void Coast::begin() {
  pausing_ = recovering_ = true;
  doubts_ = false;
  paused_ = doubt_ = 0;
  excess_ = fallen_ = windows_ = 0;
  carried_least_ = std::numeric_limits<std::int32_t>::max();
}

bool Coast::add(const Window& window) {
  const Slopes& slopes = window.slopes;
  const std::int32_t carried = slopes.blown + slopes.melted;
  // The heat of before a pause is felt for a while.
  if (slopes.heating >= model_->rise * (pausing_ ? much : showing) / 100) {
    heating_ = slopes.heating;
    warmed_ = warmed_by(slopes);
  }
  if (!pausing_) {
    if (slopes.heating > model_->rise / 2) recovering_ = false;
    suspect(slopes);
    if (model_->rise >= least_rise) doubt(window);
    return false;
  }
  carried_least_ = std::min(carried_least_, carried);
  if (paused_ < settling || slopes.heating > model_->rise * little / 100) return false;
  if (is_unanswered(slopes)) return true;
  if (slopes.heating > model_->rise * none / 100) return false;
  const bool is_learning = window.celsius >= least_known;
  if (slopes.measured >= 0 && heating_ > 0 && is_learning && paused_ < longest_turn) return false;
  ++windows_;
  const std::int32_t fall = late_heat(slopes) - slopes.measured;
  const std::int32_t beyond = fall - most_fall(window);
  // Of heat that is still felt a part is taken for less loss.
  const std::int32_t growth = windows_ > 1 ? std::max<std::int32_t>(fall - last_fall_, 0) : 0;
  last_fall_ = fall;
  fallen_ += fall;
  excess_ = std::max<std::int32_t>(excess_ + beyond * window.milliseconds / 1'000, 0);
  if (excess_ > limit + window.noise / 4) return true;
  // One window is enough where nothing is learnt from it.
  if (excess_ == 0 && (!is_learning || windows_ > 1)) {
    pausing_ = false;
    if (is_learning) learn(window, fall + growth);
  }
  return false;
}

// With a drift not even the strongest heater with the least losses would get hot so fast.
void Coast::suspect(const Slopes& slopes) {
  if (slopes.heating < model_->rise * much / 100) return;
  const std::int32_t unexplained = warmed_ - slopes.heating;
  fast_ = is_compared_ ? fast_ + (unexplained - fast_) / fast : unexplained;
  is_compared_ = true;
  const std::int32_t lost = warmed_ - slopes.measured;
  const std::int32_t least_lost =
      lost_at_ > 0 ? lost_ * 100 / (100 + model_->draught) : lost * model_->least_loss / 100;
  const std::int32_t measured = fast_ + heating_ - lost;
  may_drift_ = measured < heating_ * model_->most_power / 100 - least_lost - drift;
}

// What the power does not explain becomes less at once where a reading begins to drift, and changes
// slowly otherwise.
void Coast::doubt(const Window& window) {
  const Slopes& slopes = window.slopes;
  const bool is_power_known = lost_at_ > 0 && showing_left_ == 0;
  if (showing_left_ > 0 && !show_power(slopes)) return;
  // Of another power than the nominal one little is explained while the heat changes.
  if (!held_) calm_windows_ = 0;
  if (!is_power_known &&
      (held_ ? calm_windows_ < calm_after : slopes.heating < model_->rise * much / 100)) {
    calm_windows_ = held_ && std::abs(slopes.measured) <= calm ? calm_windows_ + 1 : 0;
    is_referenced_ = false;
    doubt_ = 0;
    return;
  }
  const std::int32_t carried = slopes.blown + slopes.melted;
  const std::int32_t given = slopes.heating * power_ / part_scale;
  const std::int32_t unexplained = warmed_by(slopes) - given;
  if (!is_referenced_) {
    is_referenced_ = true;
    reference_ = unexplained;
    carried_reference_ = carried;
  }
  const std::int32_t borne = most_more(slopes) + model_->rise * doubted_offset / 100 +
                             (held_ ? given * doubted_sag / 100 : 0);
  doubt_ += (reference_ - unexplained - borne) * window.milliseconds / 1'000;
  doubt_ = std::clamp<std::int32_t>(doubt_, 0, 2 * doubt_limit);
  doubts_ = doubt_ > doubt_limit + window.noise / 4;
  const std::int32_t windows = doubt_ == 0 ? slow : doubted;
  reference_ += (unexplained - reference_) / windows;
  carried_reference_ += (carried - carried_reference_) / windows;
}

// After a pause that no heat went before. A drift or a low supply shows less power, and so the most
// of it is what counts.
bool Coast::show_power(const Slopes& slopes) {
  if (slopes.heating < model_->rise * showing / 100) return false;
  const std::int32_t lost = slopes.still + slopes.blown + slopes.melted - reference_;
  shown_ += ((slopes.measured + lost) * part_scale / slopes.heating - shown_) / 4;
  power_ = std::clamp(shown_, power_, part_scale * model_->most_power / 100);
  return --showing_left_ == 0;
}

// Of any described heater in still air, in the warmest room that there may be.
std::int32_t Coast::least_lost(std::int32_t celsius) const {
  return std::max<std::int32_t>(celsius - room(), 0) / 16 * model_->loss / 62'500 *
         model_->least_loss / 100;
}

// mK/s that this heater lost a moment ago.
std::int32_t Coast::lost_before(const Slopes& slopes) const {
  return std::max<std::int32_t>(slopes.still + slopes.blown + slopes.melted - reference_, 0);
}

// mK/s that it may lose more by now, to draught, fan and filament.
std::int32_t Coast::most_more(const Slopes& slopes) const {
  const std::int32_t carried = slopes.blown + slopes.melted;
  const std::int32_t still =
      std::max<std::int32_t>(lost_before(slopes) - carried * least_carried / 100, 0);
  const std::int32_t more = std::max<std::int32_t>(carried - carried_reference_, 0);
  return (still * model_->draught + more * carried_tolerance) / 100;
}

// Of the nominal power: by the answer to the lack of heat, whether the reading drifts or not.
std::int32_t Coast::answered_power(const Slopes& slopes) const {
  const std::int32_t lacking = std::max<std::int32_t>(heating_ - slopes.heating, 1);
  return std::clamp((warmed_ - warmed_by(slopes)) * part_scale / lacking,
                    part_scale * model_->least_power / 100, part_scale * model_->most_power / 100);
}

// mK/s that the heat of before the pause still brings, by the answer to the lack of the rest.
std::int32_t Coast::late_heat(const Slopes& slopes) const {
  if (heating_ == 0) return slopes.heating;
  return slopes.heating * answered_power(slopes) / part_scale;
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
  const std::int32_t still =
      std::max<std::int32_t>(slopes.still, in_cold) * (100 + model_->draught) / 100;
  std::int32_t most = (still + carried) * model_->most_loss / 100;
  if (lost_at_ > 0) {
    const std::int32_t then = (lost_at_ - room()) / 256;
    const std::int32_t now = std::max<std::int32_t>((window.celsius - room()) / 256, then);
    const std::int32_t more_carried = std::max<std::int32_t>(carried - carried_, 0);
    const std::int32_t lost = lost_ * now / then;
    const std::int32_t windy =
        lost + (lost - carried_ * least_carried / 100) * model_->draught / 100;
    most = std::min(most, windy + more_carried * (100 + carried_tolerance) / 100);
    // A power that a supply has changed meanwhile shows too little loss.
    if (is_referenced_) {
      const std::int32_t before =
          std::max<std::int32_t>(lost_before(slopes), lost * known_part / 100);
      most = std::min(most, before + most_more(slopes) + model_->rise * doubted_offset / 100);
    }
  } else if (is_referenced_ && held_ && heating_ > 0) {
    // In a hold it lost what it was given.
    const std::int32_t lost = (lost_before(slopes) + most_more(slopes)) * first_part / 100;
    most = std::min(
        most, lost * answered_power(slopes) / part_scale + model_->rise * doubted_offset / 100);
  }
  return most + model_->rise * offset / 100;
}

std::int32_t Coast::room() const { return std::min(warmest_room, coldest_seen_); }

// The mean of the windows, since noise may hide much of the last; or the last, in which there is
// less heat from before.
void Coast::learn(const Window& window, std::int32_t fall) {
  if (lost_at_ == 0) wait_ = shortest_wait;
  carried_ = carried_reference_ = carried_least_;
  const std::int32_t least = least_lost(window.celsius) + carried_ * model_->least_loss / 100;
  lost_ = std::max({fallen_ / windows_, fall, least});
  lost_at_ = window.celsius;
  const Slopes& slopes = window.slopes;
  reference_ = slopes.still + slopes.blown + slopes.melted - lost_;
  is_referenced_ = true;
  showing_left_ = heating_ > 0 ? 0 : showing_windows;
  power_ = heating_ > 0 ? answered_power(slopes) : part_scale * model_->least_power / 100;
  shown_ = power_;
}

}  // namespace thermal
