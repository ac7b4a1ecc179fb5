// SPDX-License-Identifier: Apache-2.0
// A processor that hangs in the middle of a move: the whole chip stops motion without it.
#include <gtest/gtest.h>

#include <string>

#include "sim/simulation/verilated_chip.hpp"
#include "tests/loaded_printer.hpp"

namespace {

constexpr std::uint32_t clock_hz = 4'000'000;
constexpr sim::Clock millisecond = clock_hz / 1000;
// As firmware/application/motion_task.cpp sets it.
constexpr sim::Clock watchdog = 200 * millisecond;

class LastStep : public devices::StepListener {
 public:
  void stepped(const devices::StepEdge& edge) override { clock = edge.clock; }
  sim::Clock clock = 0;
};

// From now on the processor loops at its present address, and so does any trap.
void hang(sim::Chip& chip) {
  constexpr std::uint32_t memory = 0x8000'0000, bytes = CHIP_MEMORY_BYTES,
                          jump_to_itself = 0x0000'006f;
  for (std::uint32_t i = 0; i < bytes; i += 4) chip.write_memory(memory + i, jump_to_itself);
}

class HungProcessor : public testing::Test {
 protected:
  HungProcessor() {
    loaded_.printer.add_step_listener(last_step_);
    // After the time in which the boot loader listens for a host, and the start of the firmware.
    simulation_.run_until(100 * millisecond);
    // 15 s at 10 mm/s, in one segment that would go on without a processor.
    loaded_.printer.serial_line().send(simulation_.now(), "G91\nG1 X150 F600\n");
  }

  sim::VerilatedChip chip_{clock_hz};
  tests::LoadedPrinter loaded_{chip_, clock_hz, 25, 25};
  sim::Simulation& simulation_ = loaded_.simulation;
  LastStep last_step_;
};

TEST_F(HungProcessor, motion_ends_within_the_time_of_the_watchdog) {
  simulation_.run_until(600 * millisecond);
  ASSERT_GT(last_step_.clock, 595 * millisecond) << "nothing moves";
  hang(chip_);
  simulation_.run_until(1000 * millisecond);
  EXPECT_LE(last_step_.clock, 600 * millisecond + watchdog);
  EXPECT_GT(last_step_.clock, 600 * millisecond + watchdog / 2);
}

TEST_F(HungProcessor, a_processor_that_works_lets_motion_go_on) {
  simulation_.run_until(1000 * millisecond);
  EXPECT_GT(last_step_.clock, 995 * millisecond);
}

}  // namespace
