// SPDX-License-Identifier: Apache-2.0
// A printer with a sensor of filament that knows how far it is loaded.
#pragma once

#include <gmock/gmock.h>

#include "tests/application/described_machine.hpp"

namespace application_test {

using units::MicrometersPerSecond;
using units::Nanometers;

inline constexpr application::FilamentSensor sensor{.input = FakeChip::filament_input,
                                                    .low_is_out = true};
inline constexpr application::FilamentChange change{.load = Nanometers(50'000'000),
                                                    .unload = Nanometers(60'000'000),
                                                    .load_speed = MicrometersPerSecond(20'000),
                                                    .unload_speed = MicrometersPerSecond(40'000),
                                                    .purge = Nanometers(5'000'000),
                                                    .purge_speed = MicrometersPerSecond(2'000)};

class Filament : public testing::Test {
 protected:
  Filament()
      : printer([] {
          application::MachineDescription machine = machine_under_test();
          machine.filament_sensor = &sensor;
          machine.filament_change = &change;
          return machine;
        }()) {
    printer.chip.heaters[0].celsius = 200;
    talk("-> M104 S200\n<- ok\n-> G28\n<- ok\n-> G1 Z10 F600\n<- ok\n-> M400\n<- ok");
  }
  void talk(std::string_view dialogue) { printer.talk(dialogue); }
  double filament() const { return printer.chip.position[3] / 500.0; }
  // Whether the firmware says anything within a second.
  void expect_silence(double seconds = 1) { EXPECT_EQ(printer.reply(seconds), std::nullopt); }

  Printer printer;
};

}  // namespace application_test
