// SPDX-License-Identifier: Apache-2.0
// Compares what a heater is given with what its sensor shows.
#include "thermal/plausibility.hpp"

#include <algorithm>

#include "thermal/low_pass.hpp"

namespace thermal {
namespace {

constexpr units::Millicelsius surroundings{25'000};
constexpr units::Milliseconds longest_gap{1'000};

// What differs from one minute to the next, in percent: of the heat (a supply that sags), of the
// losses to fan and filament, and an absolute part, of the rise at full power. The draught is in
// the model.
constexpr std::int32_t sag = 5, wind = 30, filament = 15, offset = 2;
// A heater that is ruled out may be the right one after all, later: one that changes slowly.
constexpr std::int32_t ruled_out_milliseconds = 600'000;
// After so long without heat another sock, plate or block may be mounted.
constexpr std::int32_t forget_milliseconds = 120'000;
// No single window finds a fault, for a disturbed conversion may be in it: each adds at most so
// much of the limit, in percent.
constexpr std::int32_t window_part = 60;
// In percent of the limit for heat that is missing.
constexpr std::int32_t unasked_part = 60;

// Part of the nominal value at one of `last` + 1 steps from `least` to `most` percent, with nearly
// equal ratios: the mean of arithmetic and harmonic steps. 10 fractional bits.
constexpr std::int32_t factor(std::int32_t least, std::int32_t most, int step, int last) {
  const std::int32_t arithmetic = (least * (last - step) + most * step) * 1'024 / (last * 100);
  const std::int32_t harmonic =
      least * most / 100 * last * 1'024 / (most * (last - step) + least * step);
  return (arithmetic + harmonic) / 2;
}
static_assert(factor(50, 200, 0, 2) == 512 && factor(50, 200, 2, 2) == 2'048);
static_assert(factor(50, 200, 1, 2) == (1'280 + 819) / 2);

}  // namespace

Plausibility::Finding Plausibility::update(std::optional<units::Millicelsius> measured, Duty duty,
                                           bool wanted, const Cooling& cooling,
                                           units::Milliseconds elapsed) {
  if (model_->rise == 0) return Finding::none;
  const bool gap = !measured || elapsed > longest_gap || elapsed.count() <= 0;
  const auto milliseconds =
      static_cast<std::int32_t>(std::clamp(elapsed, units::Milliseconds(0), longest_gap).count());
  arriving_ = low_pass(arriving_, duty * duty_scale, model_->heater_lag, milliseconds);
  felt_ = low_pass(felt_, arriving_, model_->sensor_lag, milliseconds);
  idle_ = idle_ && duty == 0;
  resting_ = wanted ? 0 : std::min(resting_ + milliseconds, forget_milliseconds);
  if (resting_ == forget_milliseconds) heaters_.fill({});
  if (gap) {
    before_.reset();
    begin_window();
    return Finding::none;
  }
  sum_.celsius += measured->count();
  sum_.duty += felt_ / duty_scale;
  sum_.milliseconds += milliseconds;
  ++updates_;
  if (sum_.milliseconds < static_cast<std::int32_t>(model_->window.count())) return Finding::none;
  const Window now{sum_.celsius / updates_, sum_.duty / updates_, sum_.milliseconds};
  Finding finding = Finding::none;
  if (before_) {
    const Slopes slopes = slopes_until(now, cooling);
    if (is_heat_unasked(slopes, now.milliseconds)) {
      finding = Finding::heat_unasked;
    } else if (wanted && is_heat_missing(slopes, now.milliseconds)) {
      finding = Finding::heat_missing;
    }
  }
  if (finding == Finding::none && probe_.is_unanswered(now.celsius)) {
    finding = Finding::sensor_frozen;
  }
  before_ = now;
  begin_window();
  return finding;
}

void Plausibility::begin_window() {
  sum_ = {};
  updates_ = 0;
  idle_ = true;
}

// From the middle of one window to the middle of the next. What no model explains is cut, so that
// no product below exceeds 31 bits.
Plausibility::Slopes Plausibility::slopes_until(const Window& now, const Cooling& cooling) const {
  const std::int32_t milliseconds = (before_->milliseconds + now.milliseconds) / 2;
  const std::int32_t above =
      std::max<std::int32_t>((before_->celsius + now.celsius) / 2 - surroundings.count(), 0) / 16;
  // Of millionths per second.
  const auto lost = [above](std::int32_t loss) { return above * loss / 62'500; };
  const std::int32_t steepest = 4 * model_->rise;
  return {.measured = std::clamp((now.celsius - before_->celsius) * 1'000 / milliseconds, -steepest,
                                 steepest),
          .heating = model_->rise * ((before_->duty + now.duty) / 2) / full_duty,
          .still = lost(model_->loss),
          .blown = lost(model_->fan_loss * cooling.fan / 255),
          .melted = lost(model_->filament_loss * (cooling.filament.count() / 64) / 16)};
}

// How fast it should cool down does not matter here.
bool Plausibility::is_heat_unasked(const Slopes& slopes, std::int32_t milliseconds) {
  if (!idle_) {
    unasked_ = 0;
    return false;
  }
  const std::int32_t explained =
      (model_->rise * offset + slopes.heating * model_->most_power) / 100;
  const std::int32_t limit = model_->missing_limit.count() * unasked_part / 100;
  const std::int32_t change = (slopes.measured - explained) * milliseconds / 1'000;
  unasked_ = std::clamp<std::int32_t>(unasked_ + std::min(change, limit * window_part / 100), 0,
                                      2 * limit);
  return unasked_ > limit;
}

bool Plausibility::is_heat_missing(const Slopes& slopes, std::int32_t milliseconds) {
  const auto in_window = [milliseconds](std::int32_t slope) {
    return slope * milliseconds / 1'000;
  };
  const std::int32_t limit = model_->missing_limit.count();
  const std::int32_t comes_back = limit * milliseconds / ruled_out_milliseconds;
  const std::int32_t spread = in_window(model_->rise * offset / 100);
  const std::int32_t measured = in_window(slopes.measured);
  const std::int32_t heating = in_window(slopes.heating);
  const std::int32_t lost = in_window(slopes.still + slopes.blown + slopes.melted);
  const std::int32_t uncertain = slopes.blown * wind + slopes.melted * filament;
  const std::int32_t least_lost = lost - in_window(uncertain / 100);
  const std::int32_t most_lost =
      lost + in_window((uncertain + slopes.still * model_->draught) / 100);

  const auto rules_out = [=](std::int16_t& sum, std::int32_t change) {
    if (sum > limit) {
      sum = static_cast<std::int16_t>(change > 0 ? 2 * limit : sum - comes_back);
    } else {
      const std::int32_t added =
          std::max<std::int32_t>(sum + std::min(change, limit * window_part / 100), 0);
      sum = static_cast<std::int16_t>(added > limit ? 2 * limit : added);
    }
    return sum > limit;
  };
  std::array<std::int32_t, steps> least_cools{}, most_cools{};
  for (int loss = 0; loss < steps; ++loss) {
    const std::int32_t part = factor(model_->least_loss, model_->most_loss, loss, steps - 1);
    const auto index = static_cast<std::size_t>(loss);
    least_cools[index] = least_lost * part / 1'024;
    most_cools[index] = most_lost * part / 1'024;
  }
  bool explained = false;
  for (int power = 0; power < steps; ++power) {
    const std::int32_t warms =
        heating * factor(model_->least_power, model_->most_power, power, steps - 1) / 1'024;
    const std::int32_t most_missing = warms * (100 - sag) / 100 - spread - measured;
    const std::int32_t most_surplus = measured - warms - spread;
    for (int loss = 0; loss < steps; ++loss) {
      const auto index = static_cast<std::size_t>(loss);
      Evidence& against = heaters_[static_cast<std::size_t>(power * steps + loss)];
      const bool is_too_strong = rules_out(against.missing, most_missing - most_cools[index]);
      const bool is_too_weak = rules_out(against.surplus, most_surplus + least_cools[index]);
      // A heater stronger than any that is described is no danger that this could find.
      const bool strongest = power == steps - 1 && loss == 0;
      explained = explained || (!is_too_strong && (!is_too_weak || strongest));
    }
  }
  return !explained;
}

}  // namespace thermal
