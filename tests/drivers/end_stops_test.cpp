// SPDX-License-Identifier: Apache-2.0
// The end stops' driver against the end stop inputs.
#include "drivers/end_stops.hpp"

#include <gtest/gtest.h>
#include <Vend_stops.h>

#include "registers/end_stops_registers.hpp"
#include "tests/drivers/verilated_bus.hpp"

namespace {

struct EndStops : testing::Test {
  tests::VerilatedPeripheral<Vend_stops> chip{registers::end_stops::base};
  drivers::EndStops end_stops;
};

TEST_F(EndStops, trigger_nothing_before_they_are_configured) {
  chip->switches = 0xFF;
  chip.clock(1'000);
  EXPECT_EQ(end_stops.triggered(), 0);
  EXPECT_EQ(end_stops.raw_levels(), 0xFF);
  EXPECT_EQ(end_stops.filtered_levels(), 0xFF);
  EXPECT_EQ(chip->triggered, 0);
}

TEST_F(EndStops, trigger_where_enabled_in_either_polarity) {
  end_stops.configure({.enabled = 0b0000'0111, .active_low = 0b0000'0100, .filter_cycles = 10});
  chip->switches = 0b1000'0101;
  chip.clock(20);
  EXPECT_EQ(end_stops.triggered(), 0b0000'0001);
  chip->switches = 0b1000'0010;
  chip.clock(20);
  EXPECT_EQ(end_stops.triggered(), 0b0000'0110);
  EXPECT_EQ(chip->triggered, 0b0000'0110);
}

TEST_F(EndStops, follow_after_the_filter_time) {
  end_stops.configure({.enabled = 1, .active_low = 0, .filter_cycles = 500});
  chip.clock(10);
  chip->switches = 1;
  chip.clock(250);
  EXPECT_EQ(end_stops.raw_levels(), 1);
  EXPECT_EQ(end_stops.filtered_levels(), 0);
  EXPECT_FALSE(chip->triggered);
  chip.clock(260);
  EXPECT_EQ(end_stops.triggered(), 1);
  EXPECT_EQ(chip->triggered, 1);

  chip->switches = 0;
  const std::uint64_t released = chip.now();
  while (chip->triggered && chip.now() < released + 1'000) chip.clock();
  // Two clocks to synchronise, one to judge.
  EXPECT_EQ(chip.now() - released, 503u);
}

TEST_F(EndStops, do_not_see_shorter_pulses) {
  end_stops.configure({.enabled = 0xFF, .active_low = 0, .filter_cycles = 50});
  bool ever = false;
  chip.after_clock = [&] { ever = ever || chip->triggered != 0; };
  for (unsigned length = 1; length < 50; ++length) {
    chip->switches = 0xFF;
    chip.clock(length);
    chip->switches = 0;
    chip.clock(1);
  }
  EXPECT_FALSE(ever);
  chip->switches = 0xFF;
  chip.clock(53);
  EXPECT_TRUE(ever);
}

}  // namespace
