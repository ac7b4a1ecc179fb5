// SPDX-License-Identifier: Apache-2.0
// One heater with its sensor: control to the target, arrival, protections, and a latched fault.
#include "thermal/heater_loop.hpp"

#include <algorithm>

namespace thermal {
namespace {

// This near to the target a heater is settled enough to be probed.
constexpr units::Millicelsius near{3'000};

}  // namespace

void HeaterLoop::set_target(units::Millicelsius target) {
  const units::Millicelsius settled = std::clamp(target, off, highest_target());
  if (settled == target_) return;
  if (target_ == off || settled == off) controller_.reset();
  target_ = settled;
  arrival_.restart();
  protection_.restart();
}

Duty HeaterLoop::update(const Temperature& measured, units::Milliseconds now) {
  watch_plausibility(measured, now);
  if (measured) {
    faulty_since_.reset();
    if (!temperature_) latest_.fill(*measured);
    temperature_ = *measured;
    duty_ = heat(*measured, now);
  } else {
    duty_ = wait_for_sensor(measured.error(), now);
  }
  last_update_ = now;
  return duty_;
}

void HeaterLoop::watch_plausibility(const Temperature& measured, units::Milliseconds now) {
  const units::Milliseconds elapsed = last_update_ ? now - *last_update_ : units::Milliseconds(0);
  using Finding = Plausibility::Finding;
  switch (plausibility_.update(measured ? std::optional(*measured) : std::nullopt, duty_,
                               target_ != off ? std::optional(target_) : std::nullopt, cooling_,
                               elapsed)) {
    case Finding::none:
      break;
    case Finding::heat_missing:
      // A heater that is off may cool down freely.
      if (target_ != off) {
        stop_with(protection_.holding() ? Fault::thermal_runaway : Fault::heating_failed);
      }
      break;
    case Finding::heat_unasked:
      stop_with(Fault::unasked_heat);
      break;
    case Finding::sensor_frozen:
      if (target_ != off) stop_with(Fault::sensor_frozen);
      break;
    case Finding::sensor_implausible:
      if (target_ != off) stop_with(Fault::sensor_implausible);
      break;
  }
}

// One faulty conversion may be a disturbance: no heat meanwhile, and a fault if it lasts. A heater
// that is off may lack its sensor: many a machine has no heated bed.
Duty HeaterLoop::wait_for_sensor(Fault fault, units::Milliseconds now) {
  if (!faulty_since_) faulty_since_ = now;
  if (now - *faulty_since_ >= settings_.sensor_patience) {
    temperature_.reset();
    if (target_ != off) stop_with(fault);
  }
  return 0;
}

Duty HeaterLoop::heat(units::Millicelsius measured, units::Milliseconds now) {
  if (measured > settings_.maximum) stop_with(Fault::max_temperature);
  // The middle one of three, so that a single wild conversion is neither a cold heater nor a goal.
  const auto [lower, upper] = std::minmax({latest_[0], latest_[1]});
  const units::Millicelsius steady = std::clamp(measured, lower, upper);
  latest_ = {latest_[1], measured};
  if (steady < settings_.minimum && target_ != off) stop_with(Fault::min_temperature);
  if (const auto fault = protection_.update(target_, steady, now)) stop_with(*fault);
  if (fault_ || target_ == off) return plausibility_.probe(false, 0);
  arrival_.update(target_, measured, now);
  const units::Milliseconds elapsed = last_update_ ? now - *last_update_ : units::Milliseconds(0);
  const Duty wanted =
      controller_.update(target_, measured - plausibility_.expected_answer(), elapsed);
  const Duty duty =
      plausibility_.coast({.celsius = steady.count(),
                           .below = (target_ - steady).count(),
                           .full = wanted == full_duty,
                           .held = protection_.holding(),
                           .milliseconds = static_cast<std::int32_t>(elapsed.count())},
                          wanted);
  if (plausibility_.is_pausing()) {
    protection_.pause();
    controller_.reset();
  }
  const bool settled =
      protection_.holding() && std::clamp(measured, target_ - near, target_ + near) == measured;
  return plausibility_.probe(settled, duty);
}

void HeaterLoop::stop_with(Fault fault) {
  if (!fault_) fault_ = fault;
  duty_ = 0;
  target_ = off;
  controller_.reset();
  arrival_.restart();
}

void HeaterLoop::clear_fault() {
  fault_.reset();
  protection_.restart();
}

}  // namespace thermal
