// SPDX-License-Identifier: Apache-2.0
// Compares what a heater is given with what its sensor shows.
#include "thermal/plausibility.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "thermal/low_pass.hpp"
#include "units/loop_bound.hpp"

namespace thermal {
namespace {

constexpr units::Millicelsius surroundings{25'000};
// Rooms are of 5 to 45 degrees. The least that a block loses is that in the warmest room, up to 125
// degrees; above, the tolerance of the losses covers rooms. The most, where it is colder than
// `coldest`, is what the model loses at `coldest`.
constexpr units::Millicelsius warmest_room{45'000}, coldest{50'000};
// So far beyond its target the heat that a block needs is not compared with what it needed before;
// nor, once it has come so near, at targets at which an enclosure that is opened counts for more
// than draught.
constexpr units::Millicelsius compared_band{20'000}, reached_band{1'000}, least_compared{125'000};
constexpr units::Milliseconds longest_gap{1'000};
// The last temperature stands in for faulty conversions for so long.
constexpr std::int32_t most_faulty_milliseconds = 600;

// What differs from one minute to the next, in percent: of the heat (a supply that sags), of the
// losses to fan and filament, and an absolute part, of the rise at full power. The draught is in
// the model.
constexpr std::int32_t sag = 5, wind = 30, filament = 15, offset = 2;
// A supply may sag by so much while pauses watch the heater.
constexpr std::int32_t sag_while_watched = 8;
// A heater that is ruled out may be the right one after all, later: one that changes slowly.
constexpr std::int32_t ruled_out_milliseconds = 600'000;
// After so long without heat another sock, plate or block may be mounted.
constexpr std::int32_t forget_milliseconds = 120'000;
// A heater that does not hold its target in draught with so much power left, in percent, is none,
// unless the nominal one does not either.
constexpr std::int32_t reserve = 20;
// In mK: what no model explains is cut, so that no product exceeds 31 bits.
constexpr std::int32_t most_in_window = 1'000'000;
// Heat of so much of full power, in percent, is no cause to look for more.
constexpr std::int32_t most_watched = 75;
// In percent of the limit for heat that is missing.
constexpr std::int32_t unasked_part_at_target = 9, unasked_part_off = 60;
// The sun, an enclosure or the other heater warm more slowly than that the limit is reached
// in this time.
constexpr std::int32_t neighbour_milliseconds = 60'000;

// mK/s at this temperature, of millionths per second.
std::int32_t slope_lost(std::int32_t millicelsius, std::int32_t loss) {
  return std::max<std::int32_t>(millicelsius - surroundings.count(), 0) / 16 * loss / 62'500;
}

}  // namespace

Plausibility::Finding Plausibility::update(std::optional<units::Millicelsius> measured, Duty duty,
                                           std::optional<units::Millicelsius> target,
                                           const Cooling& cooling, units::Milliseconds elapsed) {
  if (model_->rise == 0) return Finding::none;
  const bool wanted = target.has_value();
  const auto milliseconds =
      static_cast<std::int32_t>(std::clamp(elapsed, units::Milliseconds(0), longest_gap).count());
  // Single faulty conversions must not restart the comparison: it would never finish.
  if (measured) {
    last_measured_ = measured;
    faulty_ = 0;
  } else {
    faulty_ = std::min(faulty_ + milliseconds, 2 * most_faulty_milliseconds);
    if (faulty_ > most_faulty_milliseconds) last_measured_.reset();
    measured = last_measured_;
  }
  const bool gap = !measured || elapsed > longest_gap || elapsed.count() <= 0;
  arriving_ = low_pass(arriving_, duty * duty_scale, model_->heater_lag, milliseconds);
  felt_ = low_pass(felt_, arriving_, model_->sensor_lag, milliseconds);
  probe_.follow(milliseconds);
  if (cooling.fan != fan_) probe_.disturb();
  fan_ = cooling.fan;
  idle_ = idle_ && duty == 0;
  resting_ = wanted ? 0 : std::min(resting_ + milliseconds, forget_milliseconds);
  if (resting_ == forget_milliseconds) {
    heaters_.fill({});
    ascent_.forget();
    coast_.forget();
  }
  if (!wanted || gap) {
    ascent_.restart();
    coast_.restart();
  }
  if (gap) {
    raw_windows_ = 0;
    before_.reset();
    begin_window();
    return Finding::none;
  }
  sum_.celsius += measured->count();
  lowest_ = std::min(lowest_, measured->count());
  highest_ = std::max(highest_, measured->count());
  sum_.duty += felt_ / duty_scale;
  sum_.milliseconds += milliseconds;
  ++updates_;
  if (sum_.milliseconds < static_cast<std::int32_t>(model_->window.count())) {
    return probe_.is_unanswered_for_long() ? Finding::sensor_frozen : Finding::none;
  }
  noise_ = std::max(highest_ - lowest_, noise_ - noise_ / 8);
  // Without the lowest and the highest, one of which may be disturbed.
  const std::int32_t celsius =
      updates_ > 2 ? (sum_.celsius - lowest_ - highest_) / (updates_ - 2) : sum_.celsius / updates_;
  const Window raw{celsius, sum_.duty / updates_, sum_.milliseconds};
  const Finding finding = compare(raw, target, cooling);
  raw_ = {raw_[1], raw};
  raw_windows_ = std::min(raw_windows_ + 1, 2);
  begin_window();
  return finding;
}

Plausibility::Finding Plausibility::compare(const Window& raw,
                                            std::optional<units::Millicelsius> target,
                                            const Cooling& cooling) {
  const bool frozen =
      probe_.is_unanswered(raw.celsius, highest_ - lowest_, model_->rise * raw.duty / full_duty,
                           slope_lost(raw.celsius, filament_loss(cooling)), raw.milliseconds);
  if (raw_windows_ < 2) return Finding::none;
  // One window with a disturbed conversion is no middle one.
  const auto [first, second] = raw_;
  const auto [lower, upper] = std::minmax(first.celsius, second.celsius);
  const Window now{std::clamp(raw.celsius, lower, upper), second.duty, second.milliseconds};
  Finding finding = Finding::none;
  if (before_) {
    const Slopes slopes = slopes_until(now, cooling);
    watch_demand(slopes, now, target);
    if (is_heat_unasked(slopes, target.has_value(), now.milliseconds)) {
      finding = Finding::heat_unasked;
    } else if (target && is_heat_missing(slopes, *target, now.milliseconds)) {
      finding = Finding::heat_missing;
    } else if (target && coast_.add({slopes, now.celsius, noise_, now.milliseconds})) {
      finding = Finding::heat_missing;
    }
    if (target && finding == Finding::none) {
      switch (ascent_.add({slopes, needed_to_hold(*target), target->count() - now.celsius, reached_,
                           coast_.is_recovering(), noise_, now.milliseconds})) {
        case Ascent::Finding::none:
          break;
        case Ascent::Finding::behind:
          finding = Finding::heat_missing;
          break;
        case Ascent::Finding::ahead:
          finding = Finding::sensor_implausible;
          break;
      }
    }
  }
  if (finding == Finding::none && frozen) finding = Finding::sensor_frozen;
  before_ = now;
  return finding;
}

void Plausibility::begin_window() {
  sum_ = {};
  updates_ = 0;
  lowest_ = std::numeric_limits<std::int32_t>::max();
  highest_ = std::numeric_limits<std::int32_t>::min();
  idle_ = true;
}

// The nominal heater's power, to hold the target in the most draught, with the reserve. In mK/s.
std::int32_t Plausibility::needed_to_hold(units::Millicelsius target) const {
  return slope_lost(target.count(), model_->loss) * (100 + model_->draught) / 100 *
         (100 + reserve) / 100;
}

// As long as one target is wanted, from half way to it: so hot that the room matters little.
void Plausibility::watch_demand(const Slopes& slopes, const Window& now,
                                std::optional<units::Millicelsius> target) {
  const bool is_new = wanted_ != target;
  wanted_ = target;
  if (is_new) reached_ = false;
  const bool is_compared = target && !is_new && !coast_.is_pausing() && is_comparable(now, *target);
  if (!is_compared) {
    demand_.restart();
    needs_too_much_.fill(false);
  }
  if (!is_compared || !demand_.add(slopes, now.milliseconds)) return;
  const HeaterGrid& grid = model_->grid;
  units::LoopBound<steps> powers;
  for (int power = 0; power < steps; ++power) {
    powers.next();
    needs_too_much_[static_cast<std::size_t>(power)] =
        demand_.has_grown({grid.halfway(2 * power - 1), grid.halfway(2 * power + 1)});
  }
}

bool Plausibility::is_comparable(const Window& now, units::Millicelsius target) {
  reached_ = reached_ || now.celsius > (target - reached_band).count();
  const bool is_half_way = 2 * now.celsius > (target + surroundings).count();
  return is_half_way && now.celsius < (target + compared_band).count() &&
         (target >= least_compared || !reached_);
}

// From the middle of one window to the middle of the next.
Slopes Plausibility::slopes_until(const Window& now, const Cooling& cooling) const {
  const std::int32_t milliseconds = (before_->milliseconds + now.milliseconds) / 2;
  const std::int32_t celsius = (before_->celsius + now.celsius) / 2;
  const std::int32_t steepest = most_in_window / milliseconds * 1'000;
  return {.measured = std::clamp((now.celsius - before_->celsius) * 1'000 / milliseconds, -steepest,
                                 steepest),
          .heating = model_->rise * ((before_->duty + now.duty) / 2) / full_duty,
          .still = slope_lost(celsius, model_->loss),
          .blown = slope_lost(celsius, model_->fan_loss * cooling.fan / 255),
          .melted = slope_lost(celsius, filament_loss(cooling))};
}

// How fast it should cool down does not matter here. What rises while the duty goes down counts,
// for a controller takes its time; but what is found is a fault only with the duty at 0.
bool Plausibility::is_heat_unasked(const Slopes& slopes, bool wanted, std::int32_t milliseconds) {
  if (slopes.heating > model_->rise * most_watched / 100) {
    unasked_ = 0;
    return false;
  }
  const std::int32_t explained =
      (model_->rise * offset + slopes.heating * model_->most_power) / 100;
  const std::int32_t limit =
      model_->missing_limit.count() * (wanted ? unasked_part_at_target : unasked_part_off) / 100 +
      noise_ / 2;
  const std::int32_t change = (slopes.measured - explained) * milliseconds / 1'000 -
                              unasked_ * milliseconds / neighbour_milliseconds;
  unasked_ = std::clamp<std::int32_t>(unasked_ + change, 0, model_->missing_limit.count());
  return idle_ && unasked_ > limit;
}

bool Plausibility::is_heat_missing(const Slopes& slopes, units::Millicelsius target,
                                   std::int32_t milliseconds) {
  const std::int32_t most_sag =
      coast_.watches(target.count() - before_->celsius) ? sag_while_watched : sag;
  const auto in_window = [milliseconds](std::int32_t slope) {
    return slope * milliseconds / 1'000;
  };
  const std::int32_t limit = model_->missing_limit.count();
  const std::int32_t comes_back = limit * milliseconds / ruled_out_milliseconds;
  const std::int32_t spread = in_window(model_->rise * offset / 100);
  const std::int32_t measured = in_window(slopes.measured);
  const std::int32_t heating = in_window(slopes.heating);
  const std::int32_t in_warmest_room =
      slopes.still - slope_lost(warmest_room.count(), model_->loss);
  const std::int32_t least_still =
      std::clamp<std::int32_t>(in_warmest_room * 5 / 4, 0, slopes.still);
  const std::int32_t most_still = std::max(slopes.still, slope_lost(coldest.count(), model_->loss));
  const std::int32_t carried = slopes.blown + slopes.melted;
  const std::int32_t uncertain = (slopes.blown * wind + slopes.melted * filament) / 100;
  const std::int32_t least_lost = in_window(least_still + carried - uncertain);
  const std::int32_t most_lost =
      in_window(most_still + carried + uncertain + most_still * model_->draught / 100);

  const auto rules_out = [=](std::int16_t& sum, std::int32_t change) {
    if (sum > limit) {
      sum = static_cast<std::int16_t>(change > 0 ? 2 * limit : sum - comes_back);
    } else {
      const std::int32_t added = std::max<std::int32_t>(sum + change, 0);
      sum = static_cast<std::int16_t>(added > limit ? 2 * limit : added);
    }
    return sum > limit;
  };
  std::array<std::int32_t, steps> least_cools{}, most_cools{}, needed{}, parts{};
  const std::int32_t nominal_needed = needed_to_hold(target);
  for (int loss = 0; loss < steps; ++loss) {
    const std::int32_t part = model_->grid.loss(loss);
    const auto index = static_cast<std::size_t>(loss);
    least_cools[index] = least_lost * part / 1'024;
    most_cools[index] = most_lost * part / 1'024;
    needed[index] = nominal_needed * part / 1'024;
    parts[index] = part;
  }
  bool explained = false;
  units::LoopBound<steps, 1> powers;
  for (int power = 0; power < steps; ++power) {
    powers.next();
    const std::int32_t part = model_->grid.power(power);
    const std::int32_t warms = heating * part / 1'024;
    const std::int32_t full = model_->rise * part / 1'024 * (100 - sag) / 100;
    const std::int32_t most_missing = warms * (100 - most_sag) / 100 - spread - measured;
    const std::int32_t most_surplus = measured - warms - spread;
    const bool needs_too_much = needs_too_much_[static_cast<std::size_t>(power)];
    for (int loss = 0; loss < steps; ++loss) {
      const auto index = static_cast<std::size_t>(loss);
      Evidence& against = heaters_[static_cast<std::size_t>(power * steps + loss)];
      const bool is_too_strong = rules_out(against.missing, most_missing - most_cools[index]);
      const bool is_too_weak = rules_out(against.surplus, most_surplus + least_cools[index]);
      // A heater stronger than any that is described is no danger that this could find.
      const bool strongest = power == steps - 1 && loss == 0;
      const bool holds = full >= needed[index] ||
                         (part >= HeaterGrid::nominal && parts[index] <= HeaterGrid::nominal);
      explained =
          explained || (holds && !needs_too_much && !is_too_strong && (!is_too_weak || strongest));
    }
  }
  return !explained;
}

}  // namespace thermal
