// SPDX-License-Identifier: Apache-2.0
// The program of the chip: makes the objects, and gives each pass of the loop to the application.
#include "application/application.hpp"
#include "application/setting_reports.hpp"
#include "machine/machine.hpp"
#include "motion/s_curve.hpp"
#include "platform/boot_loader.hpp"
#include "platform/fault.hpp"
#include "platform/processor.hpp"

namespace {

constexpr const application::MachineDescription& printer = machine::machine;

constexpr thermal::ThermistorTable hotend_table{printer.hotend.thermistor};
// A table of the bed's own only where its thermistor is of another kind.
constexpr thermal::ThermistorTable own_bed_table{printer.bed.thermistor};
constexpr const thermal::ThermistorTable& bed_table =
    printer.bed.thermistor.resistance_25c == printer.hotend.thermistor.resistance_25c &&
            printer.bed.thermistor.beta_kelvin == printer.hotend.thermistor.beta_kelvin
        ? hotend_table
        : own_bed_table;
// None in an image for one extruder.
template <class Machine>
const thermal::ThermistorTable* second_hotend_table(const Machine&) {
  if constexpr (units::most_tools == 1) {
    return nullptr;
  } else {
    static constexpr thermal::ThermistorTable table{
        Machine(printer).second_tool->hotend.thermistor};
    return &table;
  }
}
constexpr std::uint32_t picoseconds_per_ohm = thermal::picoseconds_per_ohm(
    printer.converter.capacitor_picofarads, printer.converter.supply_millivolts,
    printer.converter.threshold_millivolts);

}  // namespace

// Of the serial line. A word of the image, so that the simulation can try another (--baud).
extern "C" {
[[gnu::used]] constinit volatile std::uint32_t serial_baud = printer.baud;
}

const bool application::shaping_in_image = printer.shaping.has_value();
const bool application::levelling_in_image = printer.levels();
const bool application::filament_in_image = printer.handles_filament();
const bool application::automatic_retraction_in_image = printer.fast;
const bool motion::backlash_in_image = printer.takes_up_backlash();
const bool motion::s_curve_in_image = printer.limits.s_curve;

application::Progress application::LevellingCommands::execute(ActiveCommand& command) {
  if constexpr (printer.levels()) return execute_fitted(command);
  return command.report_not_fitted();
}

int main() {
  const auto identity = drivers::read_identity();
  if (!identity) platform::halt("This firmware needs a StepFabric chip");

  if constexpr (units::most_tools > 1) {
    if (identity->heaters <= units::most_tools || identity->sensors <= units::most_tools) {
      platform::halt("This machine needs a chip with a heater for each hotend and the bed");
    }
    if (identity->axes <= units::axis_count) {
      platform::halt("This machine needs a chip with a step generator for both extruders");
    }
  }

  // Not on the stack, so that its measure is that of the calls alone.
  static application::Hardware hardware(*identity);
  application::OptionalParts parts;
  if constexpr (printer.shaping.has_value()) {
    static motion::Shaping memory;
    parts.shaping = &memory;
  }
  if constexpr (printer.levels()) {
    static motion::Levelling memory;
    parts.levelling = &memory;
  }
  if constexpr (printer.takes_up_backlash()) {
    static motion::Backlash memory;
    parts.backlash = &memory;
  }
  if constexpr (printer.handles_filament()) {
    static application::FilamentCommands memory;
    parts.filament = &memory;
  }
  static application::Application application(
      printer, {hotend_table, bed_table, picoseconds_per_ohm, second_hotend_table(printer)},
      hardware, statistics, parts);
  if (!application.start(serial_baud)) platform::halt("The clock is too slow for the serial line");

  platform::wake_by(platform::WakeSource::timer, true);
  platform::wake_by(platform::WakeSource::uart_receive, true);
  platform::wake_by(platform::WakeSource::motion_stopped, true);
  for (;;) {
    const bool more = application.update();
    if (!platform::stack_is_intact()) platform::halt("Stack overflow");
    if (application.restart_wanted() && !platform::restart()) {
      platform::halt("No boot loader in this image, reset the chip");
    }
    if (!more) platform::sleep();
  }
}
