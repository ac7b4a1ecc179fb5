// SPDX-License-Identifier: Apache-2.0
// Where the heaters of a printed file begin with --warm.
#include "tools/command/warm_start.hpp"

#include <algorithm>
#include <optional>
#include <variant>

#include "sim/machine/surroundings.hpp"
#include "sim/report/gcode_path.hpp"
#include "thermal/heater_loop.hpp"
#include "tools/command/output.hpp"

namespace command {
namespace {

// How far below its first target a warm start begins.
constexpr double warm_distance_c = 3.0;

double highest_target_c(const machine::HeaterDescription& heater) {
  constexpr double milli = 1e-3;
  return heater.max_c -
         static_cast<double>(thermal::HeaterSettings{}.target_margin.count()) * milli;
}

}  // namespace

StartTemperatures near_first_targets(const std::vector<devices::FileCommand>& commands,
                                     const machine::Description& description) {
  std::optional<double> hotend_c, bed_c;
  report::GcodePath gcode;
  for (const devices::FileCommand& command : commands) {
    const report::Request request = gcode.read(command.text);
    const auto* target = std::get_if<report::TemperatureTarget>(&request);
    if (target == nullptr || target->celsius <= 0) continue;
    std::optional<double>& start = target->bed ? bed_c : hotend_c;
    if (start) continue;
    const double highest = highest_target_c(target->bed ? description.bed : description.hotend);
    if (target->celsius > highest) {
      say_to(stderr,
             "stepfabric: --warm does not start the {} near {} °C: its highest target is {} °C\n",
             target->bed ? "bed" : "hotend", target->celsius, highest);
      continue;
    }
    start = std::max(machine::ambient_celsius, target->celsius - warm_distance_c);
  }
  return {hotend_c.value_or(machine::ambient_celsius), bed_c.value_or(machine::ambient_celsius)};
}

}  // namespace command
