// SPDX-License-Identifier: Apache-2.0
// Machines of firmware/machines on the fake chip.
#pragma once

#include <string>

#include "directories.hpp"
#include "machine_generator/description.hpp"
#include "tests/application/dialogue.hpp"

namespace application_test {

// Of firmware/machines/NAME.toml, where the description may be changed.
inline application::MachineDescription described_machine(const std::string& name) {
  application::MachineDescription machine =
      machine_generator::read_machine(PROJECT_DIRECTORY "/firmware/machines/" + name + ".toml")
          .description;
  machine.name = "described";
  return machine;
}

// Motors whose end stops are at the upper end.
inline void hang_below_end_stops(FakeChip& chip) {
  chip.end_stops_above = true;
  chip.mechanical = {-4000, -3000, -5000, 0, 0};
}

}  // namespace application_test
