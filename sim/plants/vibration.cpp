// SPDX-License-Identifier: Apache-2.0
// x'' + 2 D w x' + w^2 x = 0 between steps, each of which moves x by itself.
#include "sim/plants/vibration.hpp"

#include <cmath>
#include <numbers>

namespace plants {

Vibration::Vibration(double hertz, double damping)
    : angular_(2 * std::numbers::pi * hertz),
      damping_(damping),
      damped_(angular_ * std::sqrt(1 - damping * damping)) {}

void Vibration::move_to(double seconds, double position) {
  advance(seconds);
  // The spring is stretched at once, and the damper gives its impulse.
  deflection_ -= position - position_;
  speed_ += 2 * damping_ * angular_ * (position - position_);
  position_ = position;
}

void Vibration::advance(double seconds) {
  const double time = seconds - seconds_;
  seconds_ = seconds;
  const double decay = std::exp(-damping_ * angular_ * time);
  const double cosine = std::cos(damped_ * time);
  const double sine = std::sin(damped_ * time);
  const double drift = damping_ * angular_;
  const double in_quadrature = (speed_ + drift * deflection_) / damped_;
  const double deflection = decay * (deflection_ * cosine + in_quadrature * sine);
  speed_ = decay * (speed_ * cosine - (drift * in_quadrature + damped_ * deflection_) * sine);
  deflection_ = deflection;
}

double Vibration::amplitude() const { return std::hypot(deflection_, speed_ / angular_); }

}  // namespace plants
