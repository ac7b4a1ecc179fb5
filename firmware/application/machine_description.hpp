// SPDX-License-Identifier: Apache-2.0
// The machine's parameters in the firmware. `machine/machine.hpp`, generated from a file of
// firmware/machines, holds the instance; M-codes change copies of parts of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/guard_timings.hpp"
#include "machine/kinematics.hpp"
#include "motion/levelling.hpp"
#include "motion/limits.hpp"
#include "motion/shaping.hpp"
#include "thermal/controller.hpp"
#include "thermal/heater_model.hpp"
#include "thermal/thermistor_table.hpp"
#include "units/axes.hpp"
#include "units/quantity.hpp"

namespace application {

struct HeaterDescription {
  std::uint8_t sensor_channel{};
  std::uint8_t heater_channel{};
  thermal::NtcProperties thermistor{};
  units::Millicelsius min{};  // colder reads as a broken sensor
  units::Millicelsius max{};  // hotter is a fault; targets stay below
  thermal::ControllerGains gains{};
  thermal::HeaterModel model{};
};

// The circuit of the capacitor-charge temperature converter.
struct ConverterDescription {
  std::int32_t capacitor_picofarads{};
  units::Milliohms reference_low{};
  units::Milliohms reference_high{};
  std::int32_t supply_millivolts{};
  std::int32_t threshold_millivolts{};
};

struct MachineDescription {
  std::string_view name;
  std::uint32_t baud{};
  bool advanced_ok{};  // report the free places with each ok
  units::Milliseconds host_silence{};  // heaters off after it; 0 is never
  motion::Limits limits{};
  motion::kinematics::Chosen::Parameters kinematics{};
  units::PerAxis<units::Nanometers> homing_search{};  // from an unknown place, at most
  units::PerAxis<drivers::DriverChipTimings> drivers{};
  HeaterDescription hotend{};
  HeaterDescription bed{};
  units::Millicelsius min_extrusion{};  // below it the extruder does not turn
  ConverterDescription converter{};
  // Without it neither input shaping nor linear advance is fitted.
  std::optional<motion::ShapingSettings> shaping{};
  // Without it there is no probe, and lines do not follow the bed. It must outlive the description.
  const motion::LevellingSettings* levelling{};

  constexpr bool levels() const { return levelling != nullptr; }
};

// Whether the machine of this image has it: constants of its main.cpp, so that the linker leaves
// out what it does not have. On a host they are true, and the description decides.
extern const bool shaping_in_image;
extern const bool levelling_in_image;

// The memory of parts that a machine may have; none of those that it does not have.
struct OptionalParts {
  motion::Shaping* shaping{};
  motion::Levelling* levelling{};
};

}  // namespace application
