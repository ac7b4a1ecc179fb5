// SPDX-License-Identifier: Apache-2.0
// The firmware on a fake chip, and conversations with it written down as a person reads them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "application/application.hpp"
#include "tests/application/fake_chip.hpp"

namespace application_test {

// The machine and thermal tables that the image is built with.
const application::MachineDescription& machine_under_test();

class Printer {
 public:
  Printer() : Printer(machine_under_test()) {}
  // Of another machine.
  explicit Printer(const application::MachineDescription& machine);

  // After M999 the firmware restarts on the same chip, as in the image.
  // Plays `->`, `<-` and `<*` of tests/dialogue_steps.hpp; a reply must come within two minutes of
  // the printer's time, and busy messages are not looked at.
  void talk(std::string_view dialogue);
  void send(std::string_view line);
  // The next line from the firmware, or nothing within the time.
  std::optional<std::string> reply(double seconds = 120);
  void run(double seconds);
  // One pass of the loop, in which no time goes by but that of the bus; true if there is more to do
  // at once.
  bool pass_without_sleep() { return application_->update(); }

  FakeChip chip;
  application::Statistics counters;

  double mm(std::size_t axis) const;  // where the counters say the axis is

 private:
  void pass();
  void begin();

  application::MachineDescription machine_;
  motion::Shaping shaping_;
  motion::Levelling levelling_;
  motion::Backlash backlash_;
  application::FilamentCommands filament_;
  std::optional<application::Hardware> hardware_;
  std::unique_ptr<application::Application> application_;
};

}  // namespace application_test
