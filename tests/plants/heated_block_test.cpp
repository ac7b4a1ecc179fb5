// SPDX-License-Identifier: Apache-2.0
// The heated block obeys the heat equations, for any division into time steps.
#include "sim/plants/heated_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/machine/surroundings.hpp"
#include "tests/plants/described_heaters.hpp"

namespace {

plants::HeatedBlock hotend(double start = 22) {
  return {tests::described_hotend(), machine::ambient_celsius, start};
}

TEST(heated_block, stays_at_the_temperature_of_its_surroundings) {
  EXPECT_DOUBLE_EQ(hotend().celsius(1'000), 22);
}

TEST(heated_block, heats_up_as_fast_as_a_mendel) {
  plants::HeatedBlock block = hotend(25);
  block.set_heater(0, true);
  double seconds = 0;
  while (block.celsius(seconds) < 205) seconds += 0.1;
  EXPECT_GT(seconds, 70);
  EXPECT_LT(seconds, 120);
}

TEST(heated_block, ends_where_loss_equals_power) {
  const auto properties = tests::described_hotend();
  plants::HeatedBlock block = hotend();
  block.set_heater(0, true);
  EXPECT_NEAR(block.celsius(20'000), 22 + 40 / properties.loss_watts_per_kelvin, 1e-6);
}

TEST(heated_block, keeps_energy) {
  auto properties = tests::described_hotend();
  properties.loss_watts_per_kelvin = 0;
  plants::HeatedBlock block(properties, 22, 22);
  block.set_heater(1, true);
  block.set_heater(11, false);
  const double capacity =
      properties.path.heater_joules_per_kelvin + properties.path.block_joules_per_kelvin;
  EXPECT_NEAR(block.heater_joules(1'000), 400, 1e-6);
  EXPECT_NEAR(block.celsius(1'000), 22 + 400 / capacity, 1e-6);
}

TEST(heated_block, follows_the_closed_form_of_two_masses) {
  // Without heat, two equal masses approach each other as exp(-2 G t / C).
  plants::HeatedBlockProperties properties{.heater_watts = 10,
                                           .path = {.heater_joules_per_kelvin = 5,
                                                    .heater_to_block_watts_per_kelvin = 2,
                                                    .block_joules_per_kelvin = 5,
                                                    .sensor_lag_seconds = 1}};
  plants::HeatedBlock block(properties, 0, 0);
  block.set_heater(0, true);
  block.set_heater(1, false);
  // At 1 s: the sum is 2 K, the difference d' = 2 - 4/5 d.
  const double difference = 2.5 * (1 - std::exp(-0.8));
  EXPECT_NEAR(block.celsius(1), (2 - difference) / 2, 1e-9);
  EXPECT_NEAR(block.celsius(3), (2 - difference * std::exp(-1.6)) / 2, 1e-9);
}

TEST(heated_block, has_the_same_course_however_often_one_looks) {
  plants::HeatedBlock looked_at = hotend();
  plants::HeatedBlock left_alone = hotend();
  for (int i = 0; i < 2'000; ++i) {
    const double now = i * 0.0137;
    for (plants::HeatedBlock* block : {&looked_at, &left_alone}) block->set_heater(now, i % 3 == 0);
    for (int look = 0; look < 5; ++look) looked_at.sensor_celsius(now + look * 0.001);
  }
  EXPECT_EQ(looked_at.celsius(30), left_alone.celsius(30));
  EXPECT_EQ(looked_at.sensor_celsius(30), left_alone.sensor_celsius(30));
}

TEST(heated_block, is_cooled_by_fan_and_filament) {
  const auto after_a_minute = [](double fan, double extrusion) {
    plants::HeatedBlock block = hotend(205);
    block.set_fan(0, fan);
    block.set_extrusion(0, extrusion);
    return block.celsius(60);
  };
  EXPECT_LT(after_a_minute(1, 0), after_a_minute(0.5, 0));
  EXPECT_LT(after_a_minute(0.5, 0), after_a_minute(0, 0) - 1);
  EXPECT_LT(after_a_minute(0, 5), after_a_minute(0, 0) - 1);
}

TEST(heated_block, does_what_its_transistor_does) {
  plants::HeatedBlock block = hotend();
  block.set_fault(0, plants::HeaterFault::stuck_on);
  block.set_heater(1, false);
  EXPECT_GT(block.celsius(60), 100);
  block.set_fault(60, plants::HeaterFault::stuck_off);
  block.set_heater(61, true);
  EXPECT_LT(block.celsius(600), 60);
}

TEST(heated_block, has_a_bead_that_freezes_drifts_or_falls_out) {
  using plants::BeadFault;
  const auto bead_after = [](BeadFault fault, double seconds) {
    plants::HeatedBlock block = hotend(205);
    block.set_heater(0, true);
    block.set_bead_fault(10, fault);
    return block.sensor_celsius(10 + seconds);
  };
  const double at_once = bead_after(BeadFault::none, 0);
  EXPECT_EQ(bead_after(BeadFault::frozen, 30), at_once);
  EXPECT_NEAR(bead_after(BeadFault::none, 30) - bead_after(BeadFault::drifting, 30), 30, 1e-9);
  EXPECT_NEAR(bead_after(BeadFault::detached, 0), at_once, 1e-9);
  EXPECT_NEAR(bead_after(BeadFault::detached, 60), machine::ambient_celsius, 1);
}

TEST(heated_block, feels_heat_late_at_the_sensor) {
  plants::HeatedBlock block = hotend();
  block.set_heater(0, true);
  EXPECT_GT(block.celsius(30) - block.sensor_celsius(30), 2);
}

}  // namespace
