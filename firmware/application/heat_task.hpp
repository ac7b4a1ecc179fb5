// SPDX-License-Identifier: Apache-2.0
// Hotends and bed: reads the sensors, controls the heaters, feeds the watchdog, and finds faults.
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
#include "units/if_two_tools.hpp"

namespace application {

enum class Heater : std::uint8_t { hotend, bed, hotend_1 };

// What the compiler makes of the machine description, because it takes logarithms.
struct ThermalTables {
  const thermal::ThermistorTable& hotend;
  const thermal::ThermistorTable& bed;
  std::uint32_t picoseconds_per_ohm{};
  const thermal::ThermistorTable* second_hotend{};  // none without
};

class HeatTask {
 public:
  HeatTask(const MachineDescription& machine, const ThermalTables& tables, units::Hertz clock,
           drivers::TemperatureConverter& converter, drivers::HeaterControl& control);

  // Starts the conversions. Once.
  void start();
  // The turn of the next part: each has one in every thermal::HeaterLoop::period.
  bool is_due(units::Milliseconds now) const;
  // That turn.
  void update(const Now& now);
  // At the end of a pass, after all tasks: the watchdog's second key, if update() has
  // fed the first.
  void complete_feed();
  // Until M999 or a reset: no heat, no supply, and the watchdog is not fed any more.
  void shut_down();

  // One or two.
  std::size_t tools() const { return machine_.tools(); }
  // The one that extrudes: filament cools its hotend, and its heat permits to extrude.
  void select_tool(std::size_t tool) { tool_.fill(static_cast<std::uint8_t>(tool)); }
  static constexpr Heater hotend_of(std::size_t tool) {
    return units::most_tools == 1 || tool == 0 ? Heater::hotend : Heater::hotend_1;
  }
  Heater hotend() const { return hotend_of(tool()); }

  // What fan and filament take away from now on.
  void set_cooling(const thermal::Cooling& cooling);

  // 0 is off. Limited to the heater's range.
  void set_target(Heater heater, units::Millicelsius target);
  thermal::HeaterLoop& loop(Heater heater) { return part(heater).loop; }
  const thermal::HeaterLoop& loop(Heater heater) const { return part(heater).loop; }
  void switch_all_off();
  // Heat is requested.
  bool wanted() const;
  bool extrusion_is_cold() const { return extrusion_is_cold(tool()); }
  bool extrusion_is_cold(std::size_t tool) const;
  // Each has been measured once.
  bool all_measured() const;
  // M302: below this temperature the extruder does not turn, but where cold extrusion is allowed.
  units::Millicelsius least_extrusion() const { return least_extrusion_; }
  void set_least_extrusion(units::Millicelsius least) { least_extrusion_ = least; }
  bool cold_extrusion_allowed() const { return cold_extrusion_allowed_; }
  void allow_cold_extrusion(bool allowed) { cold_extrusion_allowed_ = allowed; }
  host_link::HeaterState state(Heater heater) const;
  // " T:205.10 /205.00 B:60.00 /60.00 @:64 B@:0", and each of two hotends.
  host_link::TextLine report() const;

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
    const thermal::ThermistorTable& table;
    thermal::Sensor sensor;
    thermal::HeaterLoop loop;
    bool limits_locked{};
    units::Millicelsius temperature{};  // the last that was measured
  };

  // Hotend and bed, and apart from them the second hotend, which an image may be without.
  static constexpr std::size_t most_parts = 1 + units::most_tools;
  using SecondHotend = units::IfTwoTools<Part>;

  template <class Machine>
  static SecondHotend second_hotend(const Machine& machine, const ThermalTables& tables);
  std::size_t parts() const { return 1 + tools(); }
  std::size_t tool() const { return units::most_tools == 1 ? 0 : tool_[0]; }
  Part& part(std::size_t index) {
    return units::most_tools > 1 && index == parts_.size() ? second_hotend_[0] : parts_[index];
  }
  const Part& part(std::size_t index) const {
    return units::most_tools > 1 && index == parts_.size() ? second_hotend_[0] : parts_[index];
  }
  Part& part(Heater heater) { return part(static_cast<std::size_t>(heater)); }
  const Part& part(Heater heater) const { return part(static_cast<std::size_t>(heater)); }
  void update(Part& part, const Now& now);
  void lock_limits(Part& part, const thermal::SensorReading& reading);
  void watch_supply(units::Milliseconds now);

  const MachineDescription& machine_;
  thermal::NominalCircuit circuit_;
  drivers::TemperatureConverter& converter_;
  drivers::HeaterControl& control_;
  std::array<Part, 2> parts_;
  [[no_unique_address]] SecondHotend second_hotend_;
  std::optional<units::Milliseconds> round_began_;
  std::size_t next_ = 0;  // of the parts
  std::string_view hardware_fault_;
  units::Millicelsius least_extrusion_;
  bool cold_extrusion_allowed_{};
  bool supply_closed_{};
  units::Milliseconds supply_missing_since_{};  // though heat is requested
  bool second_key_is_due_{};
  units::Milliseconds fed_{-thermal::HeaterLoop::period};  // when the first key was
  [[no_unique_address]] units::IfTwoTools<std::uint8_t> tool_{};
};

}  // namespace application
