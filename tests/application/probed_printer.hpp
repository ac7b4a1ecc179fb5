// SPDX-License-Identifier: Apache-2.0
// A printer with a probe above a bed that is not even.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "tests/application/dialogue.hpp"

namespace application_test {

class ProbedPrinter : public testing::Test {
 protected:
  static constexpr std::size_t x = 0, y = 1, z = 2, e = 3;
  // Of the default machine, in mm, without its descent's end.
  static constexpr double offset_x = 20, offset_y = -10, offset_z = -1.5, deepest = -1;

  static const motion::LevellingSettings& settings() {
    static const motion::LevellingSettings all = [] {
      using units::MicrometersPerSecond;
      using units::Nanometers;
      motion::LevellingSettings made;
      made.probe = {
          .input = FakeChip::probe_input,
          .offset = {Nanometers(20'000'000), Nanometers(-10'000'000), Nanometers(-1'500'000)},
          .fast_speed = MicrometersPerSecond(8'000),
          .slow_speed = MicrometersPerSecond(1'000),
          .travel_speed = MicrometersPerSecond(100'000),
          .clearance = Nanometers(5'000'000),
          .back_off = Nanometers(1'000'000),
          .deepest = Nanometers(-1'000'000)};
      made.mesh.axes[0] = {Nanometers(30'000'000), Nanometers(190'000'000), 5};
      made.mesh.axes[1] = {Nanometers(10'000'000), Nanometers(180'000'000), 4};
      made.mesh.fade_height = Nanometers(10'000'000);
      return made;
    }();
    return all;
  }
  static application::MachineDescription machine() {
    application::MachineDescription made = machine_under_test();
    made.levelling = &settings();
    return made;
  }
  // Neither flat nor bilinear.
  static double uneven(double at_x, double at_y) {
    return 0.3 * std::sin(at_x / 60) + 0.002 * (at_y - 90) - 1e-5 * (at_x - 100) * (at_y - 60);
  }

  ProbedPrinter() : printer(machine()) {
    printer.chip.heaters[0].celsius = 200;
    for (std::size_t i = 0; i < printer.chip.steps_per_mm.size(); ++i) {
      printer.chip.steps_per_mm[i] = machine().limits.axes[i].steps_per_meter.count() / 1000.0;
    }
    lay(uneven);
  }
  // The bed's height at a place.
  void lay(std::function<double(double, double)> bed) {
    printer.chip.probe_mm = [bed](double at_x, double at_y) {
      return bed(at_x + offset_x, at_y + offset_y) - offset_z;
    };
  }
  void home() { printer.talk("-> G28\n<- ok"); }
  // All that is said until ok.
  std::string answer(const std::string& line) {
    printer.send(line);
    std::string all;
    while (const auto said = printer.reply(600)) {
      if (*said == "ok") return all;
      all += *said + "\n";
    }
    ADD_FAILURE() << line << " is not answered: " << all;
    return all;
  }

  Printer printer;
};

}  // namespace application_test
