// SPDX-License-Identifier: Apache-2.0
// Decides how much to heat: PID in integers with feed-forward and an integral that cannot wind up.
#include "thermal/controller.hpp"

#include <algorithm>

namespace thermal {
namespace {

constexpr std::int64_t milli = 1'000;
constexpr std::int64_t filter_scale = 256;
constexpr std::int64_t integral_scale = 65'536;

// Conversion noise is smoothed over the first time; the slope is what the second
// filter lags behind.
constexpr std::int64_t smoothing_ms = 300;
constexpr std::int64_t slope_ms = 1'500;

// Further from the target than this the integral has nothing to learn.
constexpr std::int64_t integral_band_millicelsius = 10'000;

std::int64_t low_pass(std::int64_t state, std::int64_t input, std::int64_t time_constant_ms,
                      std::int64_t elapsed_ms) {
  return state + (input - state) * elapsed_ms / (time_constant_ms + elapsed_ms);
}

}  // namespace

void Controller::reset() {
  running_ = false;
  integral_ = 0;
}

void Controller::follow(units::Millicelsius measured, units::Milliseconds elapsed) {
  const std::int64_t input = measured.count() * filter_scale;
  if (!running_) {
    smooth_ = trailing_ = input;
    running_ = true;
    return;
  }
  smooth_ = low_pass(smooth_, input, smoothing_ms, elapsed.count());
  trailing_ = low_pass(trailing_, smooth_, slope_ms, elapsed.count());
}

Duty Controller::update(units::Millicelsius target, units::Millicelsius measured,
                        units::Milliseconds elapsed) {
  follow(measured, elapsed);
  const std::int64_t error = target.count() - smooth_ / filter_scale;
  const std::int64_t slope_per_s = (smooth_ - trailing_) * milli / (slope_ms * filter_scale);

  const std::int64_t feed_forward =
      gains_.feed_forward_duty_per_celsius * (target - gains_.surroundings).count() / milli;
  const std::int64_t proportional = gains_.duty_per_celsius * error / milli;
  const std::int64_t derivative = gains_.duty_per_celsius_per_second * slope_per_s / milli;
  const std::int64_t demand = feed_forward + proportional - derivative + integral_ / integral_scale;

  // The integral learns from the error that is left after the one for which the slope already
  // provides: nothing while the temperature comes in as planned, so that it does not overshoot.
  const std::int64_t unexplained =
      error - gains_.duty_per_celsius_per_second * slope_per_s / gains_.duty_per_celsius;
  // And an output at its end learns only what leads it back.
  const bool may_grow = unexplained < 0 ? demand > 0 : demand < full_duty;
  if (error > integral_band_millicelsius || error < -integral_band_millicelsius) {
    integral_ = 0;
  } else if (may_grow) {
    integral_ += gains_.duty_per_celsius_second * unexplained * elapsed.count() * integral_scale /
                 (milli * milli);
  }
  return static_cast<Duty>(std::clamp<std::int64_t>(demand, 0, full_duty));
}

}  // namespace thermal
