// SPDX-License-Identifier: Apache-2.0
// Decides how much to heat: PID in integers with feed-forward and an integral that cannot wind up.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace thermal {

// Of 65535: the part of the time that the heater is on, as the hardware takes it.
using Duty = std::uint16_t;
inline constexpr Duty full_duty = 65'535;

struct ControllerGains {
  std::int32_t duty_per_celsius{};  // of error; above 0
  std::int32_t duty_per_celsius_second{};  // of error's integral
  std::int32_t duty_per_celsius_per_second{};  // against the temperature's slope
  std::int32_t feed_forward_duty_per_celsius{};  // of the target above the surroundings
  units::Millicelsius surroundings{25'000};
};

class Controller {
 public:
  explicit constexpr Controller(const ControllerGains& gains) : gains_(gains) {}

  // One step, `elapsed` after the one before (0 for the first). Steps should come about
  // every 100 ms.
  Duty update(units::Millicelsius target, units::Millicelsius measured,
              units::Milliseconds elapsed);
  // Forgets the past.
  void reset();

 private:
  void follow(units::Millicelsius measured, units::Milliseconds elapsed);

  ControllerGains gains_;
  bool running_ = false;
  // Both with 2^-8 millidegrees, so that a slow filter does not lose what it is given.
  std::int64_t smooth_ = 0;
  std::int64_t trailing_ = 0;
  std::int64_t integral_ = 0;  // duty * 2^-16
};

}  // namespace thermal
