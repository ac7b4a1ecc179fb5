// SPDX-License-Identifier: Apache-2.0
// What ends a leap over counting clocks is named: with each event alone, and all others far.
#include <gtest/gtest.h>

#include "sim/counting/counts.hpp"

namespace {

using counting::Counts;
using sim::LeapEnd;

constexpr sim::Clock soon = 100, later = 1000;

Counts far_from_events() {
  constexpr std::uint32_t far = 0x7f'ffff;
  Counts counts;
  counts.timer = {.now = 7, .deadline = far, .reached = false};
  counts.converter_tick = counts.heater_tick = counts.heater_slot = {.phase = 0, .last = far};
  counts.converter_wakes.fill(far);
  counts.motion_watchdog = {.limit = 0, .moving = false, .left = ~std::uint32_t{0}};
  counts.fan = {.slot_cycles = far, .duty = 0, .remaining_cycles = far};
  return counts;
}

void expect_end(Counts counts, LeapEnd end) {
  const Counts before = counts;
  const sim::Clock clocks = counts.carry(later, 1);
  ASSERT_GT(clocks, 0u);
  ASSERT_LE(clocks, soon);
  EXPECT_EQ(before.end_of(clocks), end);
}

TEST(Counts, without_an_event_are_carried_to_the_limit) {
  EXPECT_EQ(far_from_events().carry(later, 1), later);
}

TEST(Counts, name_the_timer) {
  Counts counts = far_from_events();
  counts.timer.deadline = counts.timer.now + soon;
  expect_end(counts, LeapEnd::timer);
}

TEST(Counts, name_the_converter) {
  Counts counts = far_from_events();
  counts.converter_tick.last = soon;
  expect_end(counts, LeapEnd::converter);
  counts = far_from_events();
  counts.converter_wakes.back() = soon;
  expect_end(counts, LeapEnd::converter);
}

TEST(Counts, name_the_heater_control) {
  Counts counts = far_from_events();
  counts.heater_tick.last = soon;
  expect_end(counts, LeapEnd::heater);
  counts = far_from_events();
  counts.heater_slot.last = soon;
  expect_end(counts, LeapEnd::heater);
}

TEST(Counts, name_the_motion_watchdog) {
  Counts counts = far_from_events();
  counts.motion_watchdog = {.limit = later, .moving = true, .left = soon};
  expect_end(counts, LeapEnd::motion_watchdog);
}

TEST(Counts, name_the_time_base) {
  Counts counts = far_from_events();
  counts.time_base = {.active = true, .advance = true, .rate = ~std::uint64_t{0} / soon};
  expect_end(counts, LeapEnd::time_base);
}

TEST(Counts, name_the_fan) {
  Counts counts = far_from_events();
  counts.fan = {.slot_cycles = soon / 2,
                .duty = 128,
                .remaining_cycles = soon / 2,
                .slot = 0,
                .slots_on = 1,
                .level = true};
  expect_end(counts, LeapEnd::fan);
}

}  // namespace
