// SPDX-License-Identifier: Apache-2.0
// The machine's parameters in the firmware. `machine/machine.hpp`, generated from a file of
// firmware/machines, holds the instance; M-codes change copies of parts of it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>

#include "application/filament.hpp"
#include "drivers/guard_timings.hpp"
#include "machine/kinematics.hpp"
#include "machine/tools.hpp"
#include "motion/backlash.hpp"
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

// Where a nozzle is from that of tool 0: X, Y, Z.
using ToolOffset = std::array<units::Nanometers, 3>;

// What happens at a change of tools, in the words of M217.
struct ToolChange {
  units::Nanometers swap{};  // S: drawn back from the nozzle that rests
  units::Nanometers resume{};  // B: by how much more it is pushed forward again
  units::Nanometers prime{};  // E: extruded by the new one in addition
  units::Nanometers lift{};  // Z: of both nozzles above the place, meanwhile
  units::MicrometersPerSecond prime_speed{};  // P
  units::MicrometersPerSecond retract_speed{};  // R
  units::MicrometersPerSecond unretract_speed{};  // U
};

// A second hotend with its extruder, T1: it has the settings of the axis E, and one of them turns
// at a time.
struct SecondTool {
  HeaterDescription hotend{};
  ToolOffset offset{};
  drivers::DriverChipTimings driver{};
  ToolChange change{};
};

// In an image for one extruder.
struct NoSecondTool {
  constexpr bool has_value() const { return false; }
  const SecondTool* operator->() const;  // named in code that is left out
};

// A chip with so much memory has firmware that is compiled for speed.
inline constexpr std::uint32_t fast_memory_bytes = 192 * 1024;

struct MachineDescription {
  std::string_view name;
  bool fast{};  // compiled for speed
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
  // Likewise: drives take up play; there is a sensor; lengths of loading are known.
  const motion::BacklashSettings* backlash{};
  constexpr bool takes_up_backlash() const { return backlash != nullptr; }
  const FilamentSensor* filament_sensor{};
  const FilamentChange* filament_change{};

  constexpr bool handles_filament() const {
    return filament_sensor != nullptr || filament_change != nullptr;
  }

  [[no_unique_address]] std::conditional_t<units::most_tools == 1, NoSecondTool,
                                           std::optional<SecondTool>> second_tool{};

  // Lines take a little longer to plan and to hand over (task_timing::least_line).
  constexpr bool is_heavy() const {
    const motion::kinematics::Chosen chosen(kinematics);
    return tools() > 1 || (chosen.straight() && !chosen.identity());
  }

  constexpr std::size_t tools() const { return second_tool.has_value() ? 2 : 1; }
};

// Whether the machine of this image has it: constants of its main.cpp, so that the linker leaves
// out what it does not have. On a host they are true, and the description decides.
extern const bool shaping_in_image;
extern const bool levelling_in_image;
extern const bool filament_in_image;

class FilamentCommands;

// The memory of parts that a machine may have; none of those that it does not have.
struct OptionalParts {
  motion::Shaping* shaping{};
  motion::Levelling* levelling{};
  motion::Backlash* backlash{};
  FilamentCommands* filament{};
};

}  // namespace application
