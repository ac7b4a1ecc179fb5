// SPDX-License-Identifier: Apache-2.0
// The whole firmware, made in one place of the memory. It has no heap, so its state is its bytes:
// prepared ones are copied back there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>

#include "application/application.hpp"
#include "machine/machine.hpp"
#include "tests/fuzz/property.hpp"

namespace fuzz {

inline constexpr const application::MachineDescription& description = machine::machine;
inline constexpr thermal::ThermistorTable table{description.hotend.thermistor};
inline constexpr std::uint32_t picoseconds_per_ohm = thermal::picoseconds_per_ohm(
    description.converter.capacitor_picofarads, description.converter.supply_millivolts,
    description.converter.threshold_millivolts);

struct Firmware {
  Firmware()
      : hardware(drivers::read_identity().value()),
        application(description, application::ThermalTables{table, table, picoseconds_per_ohm},
                    hardware, counters) {
    require(application.start(description.baud), "the firmware does not start");
  }
  application::Statistics counters;
  application::Hardware hardware;
  application::Application application;
};

alignas(Firmware) inline std::array<std::byte, sizeof(Firmware)> memory;
inline Firmware& firmware() { return *std::launder(reinterpret_cast<Firmware*>(memory.data())); }

}  // namespace fuzz
