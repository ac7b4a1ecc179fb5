// SPDX-License-Identifier: Apache-2.0
// What is sampled while a print runs: the queue, the processor, the heaters' duty.
#include "sim/report/chip_record.hpp"

#include <gtest/gtest.h>

#include "sim/report/temperature_record.hpp"
#include "sim/simulation/simulation.hpp"
#include "tests/sim/fake_chip.hpp"

namespace {

constexpr sim::ClockRate rate(4'000'000);

class ChipRecordTest : public testing::Test {
 protected:
  void run_until(double seconds) { simulation.run_until(rate.clocks(seconds)); }

  tests::FakeChip chip;
  sim::Simulation simulation{chip, rate};
};

TEST_F(ChipRecordTest, sees_the_depth_of_the_queue_change) {
  report::ChipRecord record(chip, rate);
  simulation.attach(record, {});
  run_until(0.1);
  chip.queue.depth = 3;
  run_until(0.2);
  chip.queue.depth = 1;
  run_until(0.3);
  const report::RangeCourse& depth = record.course().queue_depth;
  EXPECT_NEAR(depth.bucket_seconds(), 0.001, 1e-9);
  ASSERT_NEAR(static_cast<double>(depth.buckets().size()), 300, 2);
  EXPECT_EQ(depth.buckets()[50].high, 0);
  EXPECT_EQ(depth.buckets()[150].high, 3);
  EXPECT_EQ(depth.buckets()[250].high, 1);
}

TEST_F(ChipRecordTest, reports_when_underruns_came_and_how_many) {
  chip.queue.underruns = 7;  // from before
  report::ChipRecord record(chip, rate);
  simulation.attach(record, {});
  run_until(0.5);
  chip.queue.underruns = 9;
  run_until(1.0);
  chip.queue.underruns = 10;
  run_until(1.1);
  const auto& underruns = record.course().underruns;
  ASSERT_EQ(underruns.size(), 2U);
  EXPECT_NEAR(underruns[0].seconds, 0.5, 0.0021);
  EXPECT_EQ(underruns[0].count, 2U);
  EXPECT_EQ(underruns[1].count, 1U);
}

TEST_F(ChipRecordTest, loses_no_underrun_of_a_print_full_of_them) {
  report::ChipRecord record(chip, rate);
  constexpr std::size_t some_more = 10;
  for (std::size_t i = 0; i < report::ChipRecord::most_underruns + some_more; ++i) {
    ++chip.queue.underruns;
    record.wake(4000 * (i + 1));
  }
  const auto& underruns = record.course().underruns;
  EXPECT_EQ(underruns.size(), report::ChipRecord::most_underruns);
  EXPECT_EQ(underruns.back().count, 1 + some_more);
}

TEST_F(ChipRecordTest, finds_the_load_of_the_processor) {
  report::ChipRecord record(chip, rate);
  simulation.attach(record, {});
  for (int i = 1; i <= 10; ++i) {
    chip.processor.sleeping_clocks += 60'000;  // of 80 000 in 20 ms
    run_until(0.02 * i);
  }
  const auto& busy = record.course().processor_busy_percent.buckets();
  ASSERT_GE(busy.size(), 9U);
  EXPECT_NEAR(busy[5].low, 25, 0.1);
}

TEST_F(ChipRecordTest, measures_the_duty_of_a_heater_at_its_pin) {
  report::TemperatureRecord record(true, rate, 1, [] { return 50.0; });
  simulation.attach(record, sim::OutputPins::heater_pin(1));
  const auto gate = [this](double seconds, bool open) {
    chip.plan(rate.clocks(seconds), sim::OutputPins::heater_bit + 1, open);
  };
  gate(0.25, true);  // open for a fifth of the second quarter of a second, in two parts
  gate(0.275, false);
  gate(0.3, true);
  gate(0.325, false);
  gate(0.6, true);  // and from here on
  chip.plan(rate.clocks(0.1), sim::OutputPins::heater_bit, true);  // another heater
  run_until(1.1);
  const auto& samples = record.samples();
  ASSERT_EQ(samples.size(), 5U);
  EXPECT_NEAR(samples[1].duty, 0, 1e-3);
  EXPECT_NEAR(samples[2].duty, 0.2, 1e-3);
  EXPECT_NEAR(samples[3].duty, 0.6, 1e-3);
  EXPECT_NEAR(samples[4].duty, 1, 1e-3);
}

}  // namespace
