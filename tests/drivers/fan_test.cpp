// SPDX-License-Identifier: Apache-2.0
// The fan's driver against the fan output.
#include "drivers/fan.hpp"

#include <gtest/gtest.h>
#include <Vfan.h>
#include <array>

#include "registers/fan_registers.hpp"
#include "tests/drivers/verilated_bus.hpp"

namespace {

using units::Hertz;

struct Fan : testing::Test {
  tests::VerilatedPeripheral<Vfan> chip{registers::fan::base};
  drivers::Fan fan;

  struct Seen {
    std::uint64_t clocks_on{};
    std::uint64_t switched_on{};
  };
  Seen watch(std::uint64_t clocks) {
    Seen seen;
    bool before = chip->level != 0;
    for (std::uint64_t i = 0; i < clocks; ++i) {
      chip.clock();
      const bool on = chip->level != 0;
      seen.clocks_on += on;
      seen.switched_on += on && !before;
      before = on;
    }
    return seen;
  }
};

TEST_F(Fan, is_off_until_it_is_set) { EXPECT_EQ(watch(10'000).clocks_on, 0u); }

TEST_F(Fan, finds_the_nearest_frequency) {
  static_assert(drivers::Fan::slot_cycles(Hertz(100), Hertz(50'000'000)) == 1961);
  static_assert(drivers::Fan::slot_cycles(Hertz(25'000), Hertz(50'000'000)) == 8);
  static_assert(drivers::Fan::slot_cycles(Hertz(25'000), Hertz(4'000'000)) == 1);
  static_assert(drivers::Fan::slot_cycles(Hertz(0), Hertz(4'000'000)) == 0xFF'FFFF);
  SUCCEED();
}

TEST_F(Fan, has_its_duty_and_its_frequency) {
  constexpr std::uint64_t clock_hz = 4'000'000;
  // 157 clocks per slot: 99.9 Hz.
  constexpr std::uint64_t period_clocks = 157 * 255;
  fan.set_frequency(Hertz(100), Hertz(clock_hz));
  for (const std::uint8_t duty : std::to_array<std::uint8_t>({1, 64, 128, 254})) {
    fan.set_duty(duty);
    EXPECT_EQ(fan.duty(), duty);
    chip.clock(2 * period_clocks);
    const Seen seen = watch(4 * period_clocks);
    EXPECT_EQ(seen.clocks_on, 4u * duty * 157) << +duty;
    EXPECT_EQ(seen.switched_on, 4u) << +duty;
  }
}

TEST_F(Fan, is_a_constant_level_at_both_ends) {
  fan.set_frequency(Hertz(25'000), Hertz(50'000'000));
  fan.set_duty(drivers::Fan::full_duty);
  chip.clock(5'000);
  EXPECT_EQ(watch(10'000).clocks_on, 10'000u);
  fan.set_duty(0);
  chip.clock(5'000);
  EXPECT_EQ(watch(10'000).clocks_on, 0u);
}

}  // namespace
