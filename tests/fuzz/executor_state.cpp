// SPDX-License-Identifier: Apache-2.0
// The states are copied back as in printer_model.
#include "tests/fuzz/executor_state.hpp"

#include <cstring>
#include <new>
#include <string>

#include "registers/fan_registers.hpp"
#include "registers/step_generator_registers.hpp"
#include "tests/fuzz/firmware_in_memory.hpp"
#include "tests/fuzz/property.hpp"

namespace fuzz {
namespace {

constexpr std::uint32_t clocks_of_ms = InstantChip::clock_hz / 1000;

struct Snapshot {
  std::array<std::byte, sizeof(Firmware)> memory;
  InstantChip chip;
};

void prepare(std::string_view lines, int count) {
  serial_line().to_firmware = lines;
  std::string& said = serial_line().from_firmware;
  said.clear();
  for (int pass = 0; pass < 10'000; ++pass) {
    int oks = 0;
    for (std::size_t at = 0; (at = said.find("ok", at)) != std::string::npos; ++at) ++oks;
    if (oks >= count && pass > 100) return said.clear();
    pass_executor(5 * clocks_of_ms);
  }
  fail("the firmware does not come to the prepared state; it said: {}", said);
}

Snapshot prepare(ExecutorState state) {
  InstantChip& chip = instant_chip();
  chip = {};
  chip.write(registers::step_generator::Override::address, 1u << 16);
  chip.set_temperature(0, state == ExecutorState::hot ? 201 : 25);
  chip.set_temperature(1, state == ExecutorState::hot ? 61 : 25);
  new (memory.data()) Firmware;
  prepare("", 0);
  if (state != ExecutorState::started) prepare("G28\nG1 X60 Y60 Z5 F9000\nM400\n", 3);
  if (state == ExecutorState::hot) prepare("M104 S200\nM140 S60\n", 2);
  require(!firmware().application.halted(), "the firmware halts in preparation");
  chip.forget_extremes();
  return {memory, chip};
}

const Snapshot& snapshot(ExecutorState state) {
  static const std::array<Snapshot, executor_states> all{
      prepare(ExecutorState::started), prepare(ExecutorState::homed), prepare(ExecutorState::hot)};
  return all[static_cast<std::size_t>(state)];
}

}  // namespace

void restore(ExecutorState state) {
  const Snapshot& wanted = snapshot(state);
  std::memcpy(memory.data(), wanted.memory.data(), memory.size());
  instant_chip() = wanted.chip;
  serial_line().from_firmware.clear();
}

const application::Application& executor_application() { return firmware().application; }

void pass_executor(std::uint32_t clocks) {
  if (!firmware().application.update()) instant_chip().time += clocks;
}

void Observation::look() {
  const application::Application& application = firmware().application;
  std::memcpy(coordinates_.data(), &application.executor().groups().coordinates,
              coordinates_.size());
  std::memcpy(limits_.data(), &application.motion().limits(), limits_.size());
  position_ = application.motion().position();
  for (std::size_t i = 0; i < executor_heaters.size(); ++i) {
    targets_[i] = application.heat().loop(executor_heaters[i]).target();
  }
  fan_ = instant_chip().read(registers::fan::Duty::address);
  motors_ = instant_chip().motors;
  application::Positions outside{};
  outside[units::index_of(units::Axis::x)] = units::Position(units::Nanometers(-1'000'000));
  may_leave_travel_ = application.executor().groups().motion.may_go_to(outside);
}

bool Observation::targets_have_changed() const {
  static Observation now;
  now.look();
  return now.targets_ != targets_;
}

// Byte by byte, and so modes and shifts too.
void Observation::require_unchanged(std::string_view line) const {
  static Observation now;
  now.look();
  require(now.coordinates_ == coordinates_, "rejected \"{}\" changes coordinates", line);
  require(now.limits_ == limits_, "rejected \"{}\" changes limits", line);
  require(now.position_ == position_, "rejected \"{}\" moves", line);
  require(now.targets_ == targets_, "rejected \"{}\" changes a target", line);
  require(now.fan_ == fan_, "rejected \"{}\" changes the fan", line);
  require((now.motors_ & ~motors_) == 0, "rejected \"{}\" switches motors on", line);
  require(now.may_leave_travel_ == may_leave_travel_, "rejected \"{}\" changes M211", line);
}

}  // namespace fuzz
