// SPDX-License-Identifier: Apache-2.0
// A Verilated step generator with its driver, and whole lines to give it.
#pragma once

#include "drivers/step_generator.hpp"

#include <gmock/gmock.h>

#include <Vstep_generator.h>

#include "platform/bus.hpp"
#include "registers/step_generator_registers.hpp"
#include "tests/drivers/pulse_recorder.hpp"
#include "tests/drivers/verilated_bus.hpp"

namespace tests {

class StepGeneratorFixture : public testing::Test {
 protected:
  static constexpr std::uint64_t half = std::uint64_t{1} << 63u;  // tick per clock
  static constexpr std::uint32_t no_floor = 1;
  static constexpr drivers::GuardTimings shortest{1, 1, 1, 1};

  // Ticks per clock as the hardware has it.
  static constexpr std::uint64_t rate(double ticks_per_clock) {
    return static_cast<std::uint64_t>(ticks_per_clock * 18446744073709551616.0);
  }

  void SetUp() override {
    chip_.after_clock = [this] { pulses_.watch(chip_.now(), chip_->step, chip_->direction); };
    use(shortest);
  }

  void use(const drivers::GuardTimings& guard) {
    generator_.configure({guard, guard, guard, guard}, no_floor);
    platform::write(registers::step_generator::MotorEnable{.axes = 0b11111});
  }

  // A whole line at a constant rate.
  static motion::Segment line(std::array<std::int32_t, 4> steps, std::uint64_t at_rate = half) {
    motion::Segment segment{.steps = steps, .rate = at_rate};
    for (const std::int32_t count : steps) {
      const auto magnitude = static_cast<std::uint32_t>(std::abs(count));
      segment.line_ticks = std::max(segment.line_ticks, magnitude);
    }
    segment.ticks = segment.line_ticks;
    segment.ends_motion = true;
    return segment;
  }

  void append(const motion::Segment& segment) { ASSERT_TRUE(generator_.append(segment)); }

  void run_until_idle() {
    for (int i = 0; i < 100000 && !generator_.idle(); ++i) chip_.clock(50);
    ASSERT_TRUE(generator_.idle());
  }

  VerilatedPeripheral<Vstep_generator> chip_{registers::step_generator::base};
  drivers::StepGenerator generator_;
  PulseRecorder pulses_;
};

}  // namespace tests
