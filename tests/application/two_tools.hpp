// SPDX-License-Identifier: Apache-2.0
// The default machine with a second extruder, homed, both nozzles hot.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>

#include "tests/application/dialogue.hpp"

namespace application_test {

// T1 is 20 mm right, 1 mm behind and 0.25 mm below T0; a change moves nothing else.
inline application::MachineDescription machine_with_two_tools() {
  application::MachineDescription machine = machine_under_test();
  application::SecondTool& tool = machine.second_tool.emplace();
  tool.hotend = machine.hotend;
  tool.hotend.sensor_channel = tool.hotend.heater_channel = 2;
  tool.offset = {units::Nanometers{20'000'000}, units::Nanometers{1'000'000},
                 units::Nanometers{-250'000}};
  tool.driver = drivers::a4988;
  tool.change.prime_speed = units::MicrometersPerSecond{5'000};
  tool.change.retract_speed = units::MicrometersPerSecond{40'000};
  tool.change.unretract_speed = units::MicrometersPerSecond{20'000};
  return machine;
}

class TwoTools : public testing::Test {
 protected:
  static constexpr std::array<double, 5> steps_per_mm{80, 80, 2560, 500, 500};

  TwoTools() : printer(machine_with_two_tools()) {
    printer.chip.heaters[0].celsius = printer.chip.heaters[2].celsius = 200;
    execute({"G28", "M104 S200 T0", "M104 S200 T1"});
  }
  // Sends the lines, each of which is answered by nothing but ok, and waits for the end of motion.
  void execute(std::initializer_list<std::string_view> lines) {
    for (const std::string_view line : lines) printer.talk("-> " + std::string(line) + "\n<- ok\n");
    printer.talk("-> M400\n<- ok\n");
  }
  // Of the carriage and of both motors, in steps from here on.
  void expect_steps(double x, double y, double z, double e0, double e1) const {
    const std::array<double, 5> expected{x, y, z, e0, e1};
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(printer.chip.position[i], static_cast<int>(expected[i] * steps_per_mm[i])) << i;
    }
  }

  Printer printer;
};

}  // namespace application_test
