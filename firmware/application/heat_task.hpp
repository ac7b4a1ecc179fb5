// SPDX-License-Identifier: Apache-2.0
// Hotend and bed: reads the sensors, controls the heaters, feeds the watchdog, and finds faults.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "application/machine_description.hpp"
#include "application/tick_clock.hpp"
#include "drivers/heater_control.hpp"
#include "drivers/temperature_converter.hpp"
#include "host_link/replies.hpp"
#include "thermal/heater_loop.hpp"
#include "thermal/sensor.hpp"

namespace application {

enum class Heater : std::uint8_t { hotend, bed };

// What the compiler makes of the machine description, because it takes logarithms.
struct ThermalTables {
  const thermal::ThermistorTable& hotend;
  const thermal::ThermistorTable& bed;
  std::uint32_t picoseconds_per_ohm{};
};

class HeatTask {
 public:
  HeatTask(const MachineDescription& machine, const ThermalTables& tables, units::Hertz clock,
           drivers::TemperatureConverter& converter, drivers::HeaterControl& control);

  // Starts the conversions. Once.
  void start();
  // Every pass of the loop; works every thermal::HeaterLoop::period.
  void update(Now now);
  // At the end of a pass, after all tasks: the watchdog's second key, if update() has
  // fed the first.
  void complete_feed();
  // Until M999 or a reset: no heat, no supply, and the watchdog is not fed any more.
  void shut_down();

  // What fan and filament take away from now on.
  void set_cooling(const thermal::Cooling& cooling);

  // 0 is off. Limited to the heater's range.
  void set_target(Heater heater, units::Millicelsius target);
  thermal::HeaterLoop& loop(Heater heater) { return part(heater).loop; }
  const thermal::HeaterLoop& loop(Heater heater) const { return part(heater).loop; }
  // Heat is requested.
  bool wanted() const;
  bool extrusion_is_cold() const;
  // M302: below this temperature the extruder does not turn, but where cold extrusion is allowed.
  units::Millicelsius least_extrusion() const { return least_extrusion_; }
  void set_least_extrusion(units::Millicelsius least) { least_extrusion_ = least; }
  bool cold_extrusion_allowed() const { return cold_extrusion_allowed_; }
  void allow_cold_extrusion(bool allowed) { cold_extrusion_allowed_ = allowed; }
  host_link::HeaterState state(Heater heater) const;

  struct NamedFault {
    Heater heater;
    thermal::Fault fault;
  };
  std::optional<NamedFault> fault() const;
  // A failure of the protecting hardware, as a message to the host; empty if there is none.
  std::string_view hardware_fault() const { return hardware_fault_; }

 private:
  struct Part {
    const HeaterDescription& description;
    thermal::Sensor sensor;
    thermal::HeaterLoop loop;
    bool limits_locked{};
    units::Millicelsius temperature{};  // the last that was measured
  };

  Part& part(Heater heater) { return parts_[static_cast<std::size_t>(heater)]; }
  const Part& part(Heater heater) const { return parts_[static_cast<std::size_t>(heater)]; }
  void update(Part& part, Now now);
  void lock_limits(Part& part, const thermal::SensorReading& reading);
  void watch_supply(units::Milliseconds now);

  const MachineDescription& machine_;
  thermal::NominalCircuit circuit_;
  const thermal::ThermistorTable& hotend_table_;
  const thermal::ThermistorTable& bed_table_;
  drivers::TemperatureConverter& converter_;
  drivers::HeaterControl& control_;
  std::array<Part, 2> parts_;
  std::optional<units::Milliseconds> round_began_;
  std::size_t next_ = 0;  // of parts_
  std::string_view hardware_fault_;
  units::Millicelsius least_extrusion_;
  bool cold_extrusion_allowed_{};
  bool supply_closed_{};
  units::Milliseconds supply_missing_since_{};  // though heat is requested
  bool second_key_is_due_{};
};

}  // namespace application
