// SPDX-License-Identifier: Apache-2.0
// What the host sees of the heaters, and their faults.
#include "application/heat_task.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

constexpr int marlin_power_shift = 9;  // 0 .. 65535 to 0 .. 127

}  // namespace

host_link::HeaterState HeatTask::state(Heater heater) const {
  const Part& part = this->part(heater);
  return {.temperature = part.temperature,
          .target = part.loop.target(),
          .power = static_cast<std::uint8_t>(part.loop.duty() >> marlin_power_shift)};
}

host_link::TextLine HeatTask::report() const {
  if (units::most_tools == 1 || tools() == 1) {
    return host_link::temperature_report(state(Heater::hotend), state(Heater::bed));
  }
  return host_link::temperature_report(state(hotend()), state(Heater::bed),
                                       std::array{state(Heater::hotend), state(Heater::hotend_1)});
}

std::optional<HeatTask::NamedFault> HeatTask::fault() const {
  units::LoopBound<most_parts> heaters;
  for (std::size_t i = 0; i < parts(); ++i) {
    heaters.next();
    if (const auto fault = part(i).loop.fault()) return NamedFault{static_cast<Heater>(i), *fault};
  }
  return std::nullopt;
}

}  // namespace application
