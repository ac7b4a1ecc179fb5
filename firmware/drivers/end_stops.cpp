// SPDX-License-Identifier: Apache-2.0
// The end stops' registers.
#include "drivers/end_stops.hpp"

#include "platform/bus.hpp"
#include "registers/end_stops_registers.hpp"

namespace drivers {

namespace end_stops_registers = registers::end_stops;

void EndStops::configure(const EndStopSettings& settings) {
  platform::write(end_stops_registers::Filter{.cycles = settings.filter_cycles});
  platform::write(end_stops_registers::Polarity{.active_low = settings.active_low});
  platform::write(end_stops_registers::Enable{.inputs = settings.enabled});
}

std::uint8_t EndStops::triggered() const {
  return static_cast<std::uint8_t>(platform::read<end_stops_registers::Status>().triggered);
}

std::uint8_t EndStops::raw_levels() const {
  return static_cast<std::uint8_t>(platform::read<end_stops_registers::Status>().raw);
}

std::uint8_t EndStops::filtered_levels() const {
  return static_cast<std::uint8_t>(platform::read<end_stops_registers::Status>().filtered);
}

}  // namespace drivers
