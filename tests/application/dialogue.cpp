// SPDX-License-Identifier: Apache-2.0
// Runs the application's passes against the fake chip's time.
#include "tests/application/dialogue.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "machine/machine.hpp"
#include "tests/dialogue_steps.hpp"

namespace application_test {
namespace {

constexpr const application::MachineDescription& description = machine::machine;
constexpr thermal::ThermistorTable table{description.hotend.thermistor};
constexpr std::uint32_t picoseconds_per_ohm = thermal::picoseconds_per_ohm(
    description.converter.capacitor_picofarads, description.converter.supply_millivolts,
    description.converter.threshold_millivolts);
constexpr std::uint32_t clocks_per_millisecond = clock_hz / 1000;

}  // namespace

const application::MachineDescription& machine_under_test() { return description; }

Printer::Printer(const application::MachineDescription& machine) : machine_(machine) {
  const auto identity = drivers::read_identity();
  hardware_.emplace(identity.value());
  begin();
  EXPECT_EQ(reply(), "start");
}

void Printer::begin() {
  levelling_ = {};
  backlash_ = {};
  application_ = std::make_unique<application::Application>(
      machine_, application::ThermalTables{table, table, picoseconds_per_ohm, &table}, *hardware_,
      counters,
      application::OptionalParts{.shaping = machine_.shaping ? &shaping_ : nullptr,
                                 .levelling = machine_.levelling ? &levelling_ : nullptr,
                                 .backlash = machine_.backlash ? &backlash_ : nullptr,
                                 .filament = machine_.handles_filament() ? &filament_ : nullptr});
  EXPECT_TRUE(application_->start(machine::machine.baud));
}

void Printer::pass() {
  if (!application_->update()) chip.advance(clocks_per_millisecond);
  if (application_->restart_wanted()) {
    counters = {};
    begin();
  }
}

void Printer::run(double seconds) {
  const auto end = chip.time + static_cast<std::uint64_t>(seconds * clock_hz);
  while (chip.time < end) pass();
}

void Printer::send(std::string_view line) {
  for (const char c : line) chip.to_firmware.push_back(c);
  chip.to_firmware.push_back('\n');
}

std::optional<std::string> Printer::reply(double seconds) {
  const auto end = chip.time + static_cast<std::uint64_t>(seconds * clock_hz);
  for (;;) {
    const std::size_t line_end = chip.from_firmware.find('\n');
    if (line_end == std::string::npos) {
      if (chip.time >= end) return std::nullopt;
      pass();
      continue;
    }
    std::string line = chip.from_firmware.substr(0, line_end);
    chip.from_firmware.erase(0, line_end + 1);
    if (!line.starts_with("echo:busy:")) return line;
  }
}

void Printer::talk(std::string_view dialogue) {
  std::istringstream lines{std::string(dialogue)};
  for (const DialogueStep& step : dialogue_steps(lines)) {
    if (step.verb == "->") {
      send(with_checksum(step.argument));
      continue;
    }
    ASSERT_TRUE(step.verb == "<-" || step.verb == "<*") << "unknown step: " << step.text();
    const auto got = reply();
    ASSERT_TRUE(got.has_value()) << "no reply; expected: " << step.text();
    if (step.verb == "<*") {
      EXPECT_NE(got->find(step.argument), std::string::npos)
          << "expected: " << step.text() << "\ngot: " << *got;
    } else {
      EXPECT_EQ(*got, step.argument) << "in the dialogue:\n" << dialogue;
    }
  }
}

double Printer::mm(std::size_t axis) const {
  const auto per_meter = description.limits.axes[axis].steps_per_meter.count();
  return chip.position[axis] * 1000.0 / per_meter;
}

}  // namespace application_test
