// SPDX-License-Identifier: Apache-2.0
// One heater with its sensor: control to the target, arrival, protections, and a latched fault.
#pragma once

#include <array>
#include <optional>

#include "thermal/arrival.hpp"
#include "thermal/controller.hpp"
#include "thermal/fault.hpp"
#include "thermal/plausibility.hpp"
#include "thermal/protection.hpp"
#include "thermal/sensor.hpp"
#include "units/quantity.hpp"

namespace thermal {

struct HeaterSettings {
  units::Millicelsius minimum{5'000};  // colder than this with a target is a fault (MINTEMP)
  units::Millicelsius maximum{};  // hotter than this is a fault, always (MAXTEMP)
  units::Millicelsius target_margin{15'000};  // targets stay so far below the maximum
  units::Milliseconds sensor_patience{
      600};  // how long conversions may be faulty before it is a fault
  ControllerGains gains;
  ArrivalSettings arrival;
  ProtectionSettings protection;
  const HeaterModel* model = &no_heater_model;  // must outlive the loop
};

class HeaterLoop {
 public:
  static constexpr units::Millicelsius off{0};
  static constexpr units::Milliseconds period{100};  // between updates

  explicit constexpr HeaterLoop(const HeaterSettings& settings)
      : settings_(settings),
        controller_(settings.gains),
        arrival_(settings.arrival),
        protection_(settings.protection),
        plausibility_(*settings.model) {}

  // `off`, or a temperature, which is cut to highest_target(). No heat after a fault,
  // whatever the target.
  void set_target(units::Millicelsius target);
  units::Millicelsius target() const { return target_; }
  units::Millicelsius highest_target() const { return settings_.maximum - settings_.target_margin; }

  // What cools from now on.
  void set_cooling(const Cooling& cooling) { cooling_ = cooling; }

  // Call every `period` with what the sensor says; the duty is for the hardware.
  Duty update(const Temperature& measured, units::Milliseconds now);

  // The hardware has closed the gate by itself, and latched why.
  void report_cut_off() { stop_with(Fault::cut_off); }

  // The last one that was measured; nothing while the sensor is faulty.
  std::optional<units::Millicelsius> temperature() const { return temperature_; }
  // Held for the residency time since the target was set. True with the heater off.
  bool at_target() const { return target_ == off || arrival_.arrived(); }
  // Of the residency, while it runs.
  std::optional<units::Milliseconds> time_to_arrival(units::Milliseconds now) const {
    return arrival_.time_left(now);
  }
  Duty duty() const { return duty_; }

  // The first fault since start or clear_fault(); while there is one the duty is 0.
  std::optional<Fault> fault() const { return fault_; }
  void clear_fault();

 private:
  void stop_with(Fault fault);
  void watch_plausibility(const Temperature& measured, units::Milliseconds now);
  Duty wait_for_sensor(Fault fault, units::Milliseconds now);
  Duty heat(units::Millicelsius measured, units::Milliseconds now);

  HeaterSettings settings_;
  Controller controller_;
  Arrival arrival_;
  Protection protection_;
  Plausibility plausibility_;
  Cooling cooling_{};
  units::Millicelsius target_ = off;
  Duty duty_ = 0;
  std::optional<Fault> fault_;
  std::optional<units::Millicelsius> temperature_;
  std::array<units::Millicelsius, 2> latest_{};
  std::optional<units::Milliseconds> last_update_;
  std::optional<units::Milliseconds> faulty_since_;
};

}  // namespace thermal
