// SPDX-License-Identifier: Apache-2.0
// The timer's driver against the timer.
#include "drivers/timer.hpp"

#include <gtest/gtest.h>
#include <Vtimer.h>

#include "registers/timer_registers.hpp"
#include "tests/drivers/verilated_bus.hpp"

namespace {

using units::Cycles;

struct Timer : testing::Test {
  tests::VerilatedPeripheral<Vtimer> chip{registers::timer::base};
  drivers::Timer timer;

  // Clocks until the interrupt comes, at most `limit`.
  std::uint64_t clocks_to_interrupt(std::uint64_t limit) {
    std::uint64_t clocks = 0;
    while (!chip->timer_interrupt && clocks < limit) {
      chip.clock();
      ++clocks;
    }
    return clocks;
  }
};

TEST_F(Timer, reports_the_clocks_between_two_looks) {
  // The same clock of each call is the one that counts.
  const std::uint64_t clocks_before = chip.now();
  const Cycles before = timer.now();
  chip.clock(12'345);
  const std::uint64_t clocks_after = chip.now();
  EXPECT_EQ((timer.now() - before).count(),
            static_cast<std::int64_t>(clocks_after - clocks_before));
}

TEST_F(Timer, interrupts_at_the_deadline_and_not_before) {
  EXPECT_FALSE(chip->timer_interrupt);
  timer.set_deadline(Cycles(5'000));
  clocks_to_interrupt(10'000);
  ASSERT_TRUE(chip->timer_interrupt);
  EXPECT_EQ(chip.now(), 5'001u);
  chip.clock(100);
  EXPECT_TRUE(chip->timer_interrupt);
}

TEST_F(Timer, interrupts_at_once_where_the_deadline_has_passed) {
  chip.clock(1'000);
  timer.set_deadline(Cycles(500));
  EXPECT_LE(clocks_to_interrupt(10), 2u);
}

TEST_F(Timer, goes_from_deadline_to_deadline_without_a_spurious_interrupt) {
  // Crosses 2^32 both ways, where a mix of old and new halves would be in the past.
  const Cycles far(Cycles(std::int64_t{1} << 32) + Cycles(5));
  const Cycles farther((std::int64_t{5} << 32) - 1);
  for (int i = 0; i < 10; ++i) {
    for (const Cycles deadline : {far, farther, far, timer.now() + Cycles(1'000)}) {
      timer.set_deadline(deadline);
      chip.clock(20);
      ASSERT_FALSE(chip->timer_interrupt);
    }
    EXPECT_LE(clocks_to_interrupt(2'000), 1'000u);
    ASSERT_TRUE(chip->timer_interrupt);
  }
}

TEST_F(Timer, is_silent_without_a_deadline) {
  timer.set_deadline(Cycles(0));
  clocks_to_interrupt(10);
  ASSERT_TRUE(chip->timer_interrupt);
  timer.clear_deadline();
  chip.clock(1'000);
  EXPECT_FALSE(chip->timer_interrupt);
}

}  // namespace
