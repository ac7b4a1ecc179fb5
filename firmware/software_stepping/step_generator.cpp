// SPDX-License-Identifier: Apache-2.0
// drivers/step_generator.hpp where software makes the steps: the same contract, by the stepper.
#include "drivers/step_generator.hpp"

#include <algorithm>

#include "platform/bus.hpp"
#include "registers/step_generator_registers.hpp"
#include "registers/step_pins_registers.hpp"
#include "software_stepping/chip_stepper.hpp"
#include "software_stepping/interrupts.hpp"

namespace drivers {
namespace {

namespace hardware = registers::step_generator;
namespace pins = registers::step_pins;
using software_stepping::chip_stepper;
using software_stepping::Stepper;

software_stepping::Guard longest_of(const units::PerAxis<GuardTimings>& guards) {
  software_stepping::Guard longest;
  for (const GuardTimings& guard : guards) {
    longest.high = std::max(longest.high, guard.high);
    longest.low = std::max(longest.low, guard.low);
    longest.direction_setup = std::max(longest.direction_setup, guard.direction_setup);
    longest.direction_hold = std::max(longest.direction_hold, guard.direction_hold);
  }
  return longest;
}

// The emergency stop input still ends in the step generator, which remembers it.
bool emergency() { return platform::read<hardware::Status>().stopped; }

}  // namespace

void StepGenerator::configure(const units::PerAxis<GuardTimings>& guards,
                              std::uint32_t rate_floor) {
  constexpr int rate_fraction_bits = 32;
  constexpr std::uint64_t one = std::uint64_t{1}
                                << (rate_fraction_bits + software_stepping::interval_fraction_bits);
  // Its intervals are shorter than the hardware's longest: 10 ticks/s instead of 0.1.
  constexpr std::uint32_t shorter = 100;
  chip_stepper().configure(longest_of(guards),
                           one / (std::max<std::uint32_t>(rate_floor, 1) * shorter));
  platform::write(pins::Control{.software = true});
  software_stepping::begin_interrupts();
}

std::uint32_t StepGenerator::queue_depth() const { return Stepper::queue_depth; }

std::uint32_t StepGenerator::free_segments() const { return chip_stepper().free(); }

std::uint32_t StepGenerator::queued_segments() const { return chip_stepper().level(); }

bool StepGenerator::append(const motion::Segment& segment) {
  return chip_stepper().append(segment);
}

void StepGenerator::permit_motion(bool permitted) { chip_stepper().permit_motion(permitted); }

void StepGenerator::flush() { chip_stepper().flush(); }

bool StepGenerator::stretches_time() const { return false; }

void StepGenerator::set_override(std::uint32_t) {}

void StepGenerator::set_slopes(std::uint32_t, std::uint32_t) {}

std::uint32_t StepGenerator::scale() const { return 1u << 16; }

void StepGenerator::set_watchdog(std::uint32_t) {}

void StepGenerator::feed_watchdog() {}

bool StepGenerator::moving() const { return chip_stepper().moving(); }

bool StepGenerator::idle() const { return !chip_stepper().moving() && chip_stepper().level() == 0; }

StepGenerator::Snapshot StepGenerator::snapshot() {
  const software_stepping::WithoutInterrupts guarded;
  return {chip_stepper().positions(), software_stepping::long_clocks()};
}

bool StepGenerator::set_position(units::Axis axis, std::int32_t steps) {
  return chip_stepper().set_position(units::index_of(axis), steps);
}

void StepGenerator::stop() { chip_stepper().stop(); }

StepGenerator::Stop StepGenerator::stop_state() const {
  Stop result;
  result.emergency_input = emergency();
  if (result.emergency_input) chip_stepper().stop();
  result.stopped = chip_stepper().stopped();
  if (!result.stopped) return result;
  result.end_stops = chip_stepper().stop_cause();
  result.software = result.end_stops == 0 && !result.emergency_input;
  result.positions = chip_stepper().positions();
  result.clock = chip_stepper().stop_clock();
  return result;
}

bool StepGenerator::stopped() const { return stop_state().stopped; }

void StepGenerator::acknowledge_stop() {
  platform::write(hardware::Command{.acknowledge_stop = true});
  platform::write(pins::Stop{.stopped = true});
  if (!emergency()) chip_stepper().acknowledge_stop();
}

void StepGenerator::enable_motor(units::Axis axis, bool enabled) {
  auto motors = platform::read<hardware::MotorEnable>();
  const std::uint32_t mask = 1u << units::index_of(axis);
  motors.axes = enabled ? motors.axes | mask : motors.axes & ~mask;
  platform::write(motors);
}

bool StepGenerator::motor_enabled(units::Axis axis) const {
  return ((platform::read<hardware::MotorEnable>().axes >> units::index_of(axis)) & 1u) != 0;
}

void StepGenerator::enable_stop_interrupt(bool enabled) {
  auto control = platform::read<hardware::Control>();
  control.stop_interrupt_enable = enabled;
  platform::write(control);
}

StepGenerator::Counters StepGenerator::counters() const {
  const auto& counted = chip_stepper().counters();
  return {.segments = counted.segments,
          .underruns = counted.underruns,
          .stall_clocks = counted.delay_clocks,
          .axis_stall_clocks = {},
          .max_level = counted.max_level};
}

}  // namespace drivers
