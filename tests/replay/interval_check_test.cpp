// SPDX-License-Identifier: Apache-2.0
// Which intervals are recorded, chosen and replayed: without any model.
#include "sim/replay/interval_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>

#include "sim/replay/interval_recorder.hpp"
#include "sim/replay/pin_names.hpp"

namespace {

using replay::CheckPlan;
using replay::CheckResult;
using replay::Difference;
using replay::Interval;
using replay::IntervalCheck;
using replay::IntervalRecorder;
using replay::Replay;
using replay::Snapshot;
using testing::ElementsAre;

replay::Snapshot snapshot_at(sim::Clock clock) {
  Snapshot snapshot;
  snapshot.clock = clock;
  return snapshot;
}

Interval interval_of(std::size_t number) {
  Interval interval;
  interval.number = number;
  interval.start = std::make_shared<const Snapshot>(snapshot_at(100 * number));
  interval.end_clock = 100 * number + 100;
  return interval;
}

// Numbers of the intervals that a check of this plan replays, of so many.
std::multiset<std::size_t> replayed(const CheckPlan& plan, std::size_t count) {
  std::mutex mutex;
  std::multiset<std::size_t> numbers;
  IntervalCheck check(plan, [&]() -> Replay {
    return [&](const Interval& interval) {
      const std::lock_guard lock(mutex);
      numbers.insert(interval.number);
      return std::optional<Difference>();
    };
  });
  for (std::size_t number = 1; number <= count; ++number) check.take(interval_of(number));
  const CheckResult result = check.finish();
  EXPECT_EQ(result.intervals, count);
  EXPECT_EQ(result.replayed, numbers.size());
  EXPECT_EQ(result.clocks, 100 * numbers.size());
  return numbers;
}

TEST(IntervalCheck, replays_each_interval_once_on_any_number_of_threads) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    const auto numbers = replayed({.count = {}, .threads = threads}, 200);
    EXPECT_EQ(numbers.size(), 200u);
    EXPECT_EQ(std::set(numbers.begin(), numbers.end()).size(), 200u);
  }
}

TEST(IntervalCheck, chooses_some_by_its_seed) {
  const auto chosen = replayed({.count = 7, .seed = 3, .threads = 2}, 1000);
  EXPECT_EQ(std::set(chosen.begin(), chosen.end()).size(), 7u);
  EXPECT_EQ(replayed({.count = 7, .seed = 3, .threads = 1}, 1000), chosen);
  EXPECT_NE(replayed({.count = 7, .seed = 4, .threads = 1}, 1000), chosen);
}

TEST(IntervalCheck, chooses_all_where_there_are_no_more) {
  EXPECT_THAT(replayed({.count = 7, .seed = 3}, 3), ElementsAre(1, 2, 3));
}

TEST(IntervalCheck, replays_those_of_a_range) {
  EXPECT_THAT(replayed({.count = {}, .first = 3, .last = 5, .threads = 2}, 9),
              ElementsAre(3, 4, 5));
  EXPECT_THAT(replayed({.count = {}, .first = 8, .last = 12}, 9), ElementsAre(8, 9));
  EXPECT_THAT(replayed({.count = {}, .first = 4, .last = 4}, 9), ElementsAre(4));
  EXPECT_THAT(replayed({.count = {}, .first = 10, .last = 12}, 9), ElementsAre());
}

TEST(IntervalCheck, chooses_each_with_the_same_probability) {
  constexpr std::size_t intervals = 10, chosen = 4, trials = 2000;
  std::array<std::size_t, intervals + 1> times{};
  for (std::uint64_t seed = 0; seed < trials; ++seed) {
    for (const std::size_t number : replayed({.count = chosen, .seed = seed}, intervals)) {
      ++times[number];
    }
  }
  for (std::size_t number = 1; number <= intervals; ++number) {
    // 800 on average, with a standard deviation of 22.
    EXPECT_NEAR(static_cast<double>(times[number]), 800.0, 100.0) << number;
  }
}

TEST(IntervalCheck, reports_differences_and_failures_in_order_and_goes_on) {
  std::atomic<int> made = 0;
  IntervalCheck check({.count = {}, .threads = 2}, [&]() -> Replay {
    ++made;
    return [](const Interval& interval) -> std::optional<Difference> {
      if (interval.number == 9) throw std::runtime_error("an assertion");
      if (interval.number % 5 != 0) return std::nullopt;
      return Difference{
          .interval = interval.number, .clock = 1, .what = "x5", .recorded = "1", .replayed = "2"};
    };
  });
  for (std::size_t number = 1; number <= 12; ++number) check.take(interval_of(number));
  const CheckResult result = check.finish();
  EXPECT_EQ(result.replayed, 12u);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const Difference& difference : result.differences) {
    found.emplace_back(difference.interval, difference.what);
  }
  EXPECT_THAT(found,
              ElementsAre(std::pair(5, "x5"), std::pair(9, "an assertion"), std::pair(10, "x5")));
  EXPECT_GE(made, 2);  // one more where it failed
}

TEST(IntervalCheck, replays_no_more_where_it_is_cancelled) {
  std::atomic<bool> cancelled = false;
  IntervalCheck check({.count = {}, .cancelled = [&] { return cancelled.load(); }}, []() -> Replay {
    return [](const Interval&) { return std::optional<Difference>(); };
  });
  cancelled = true;
  for (std::size_t number = 1; number <= 100; ++number) check.take(interval_of(number));
  const CheckResult result = check.finish();
  EXPECT_EQ(result.replayed, 0u);
  EXPECT_EQ(result.dropped, 100u);
}

TEST(IntervalCheck, counts_those_without_a_snapshot_at_their_end) {
  IntervalCheck check({.count = {}}, []() -> Replay {
    return [](const Interval&) { return std::optional<Difference>(); };
  });
  for (std::size_t number = 1; number <= 3; ++number) {
    Interval interval = interval_of(number);
    if (number < 3) interval.end = interval_of(number + 1).start;
    check.take(std::move(interval));
  }
  const CheckResult result = check.finish();
  EXPECT_EQ(result.replayed, 3u);
  EXPECT_EQ(result.without_end, 1u);
  EXPECT_EQ(result.dropped, 0u);
}

class IntervalRecorderTest : public testing::Test {
 protected:
  std::vector<Interval> intervals_;
  IntervalRecorder recorder_{
      1000, [this](Interval&& interval) { intervals_.push_back(std::move(interval)); }};
  sim::InputPins pressed_{.end_stops = 1, .jtag = {}};
};

TEST_F(IntervalRecorderTest, wants_a_snapshot_at_first_and_when_an_interval_is_long_enough) {
  EXPECT_TRUE(recorder_.wants_snapshot(5));
  recorder_.put_snapshot(snapshot_at(5));
  EXPECT_FALSE(recorder_.wants_snapshot(5));
  EXPECT_FALSE(recorder_.wants_snapshot(1004));
  EXPECT_TRUE(recorder_.wants_snapshot(1005));
  recorder_.put_snapshot(snapshot_at(1200));
  EXPECT_FALSE(recorder_.wants_snapshot(2199));
  EXPECT_TRUE(recorder_.wants_snapshot(2200));
}

TEST_F(IntervalRecorderTest, keeps_what_changes_in_the_interval_in_which_it_does) {
  recorder_.put_inputs(3, pressed_);
  recorder_.put_snapshot(snapshot_at(5));
  recorder_.put_inputs(5, {});
  recorder_.put_inputs(6, {});
  recorder_.put_outputs(7, {1});
  recorder_.put_outputs(8, {1});
  Snapshot next = snapshot_at(1005);
  next.outputs = {1};
  recorder_.put_snapshot(next);
  recorder_.put_outputs(1006, {1});
  recorder_.put_outputs(1007, {0});
  recorder_.finish(1500);
  recorder_.finish(1500);
  ASSERT_EQ(intervals_.size(), 2u);
  ASSERT_EQ(intervals_[0].inputs.size(), 2u);
  EXPECT_EQ(intervals_[0].inputs[0].pins, pressed_);
  EXPECT_EQ(intervals_[0].inputs[1].clock, 5u);
  ASSERT_EQ(intervals_[0].outputs.size(), 1u);
  EXPECT_EQ(intervals_[0].outputs[0].clock, 7u);
  EXPECT_EQ(intervals_[0].end, intervals_[1].start);
  EXPECT_EQ(intervals_[0].end_clock, 1005u);
  ASSERT_EQ(intervals_[1].outputs.size(), 1u);
  EXPECT_EQ(intervals_[1].outputs[0].clock, 1007u);
  EXPECT_EQ(intervals_[1].end, nullptr);
  EXPECT_EQ(intervals_[1].end_clock, 1500u);
  EXPECT_EQ(recorder_.recorded_clocks(), 1495u);
}

TEST_F(IntervalRecorderTest, drops_what_cannot_be_replayed) {
  recorder_.put_snapshot(snapshot_at(0));
  recorder_.put_outputs(7, {1});
  recorder_.discard();
  EXPECT_TRUE(recorder_.wants_snapshot(10));
  recorder_.put_snapshot(snapshot_at(10));
  recorder_.finish(20);
  ASSERT_EQ(intervals_.size(), 1u);
  EXPECT_TRUE(intervals_[0].outputs.empty());
  EXPECT_EQ(recorder_.recorded_clocks(), 10u);
}

TEST(PinNames, are_those_of_the_chip) {
  using sim::OutputPins;
  EXPECT_EQ(replay::pin_names(OutputPins::bit(OutputPins::step_bit + 1) |
                              OutputPins::bit(OutputPins::enable_bit + 4)),
            "step(1) motor_enable(4)");
  EXPECT_EQ(replay::pin_names(OutputPins::sensor_pins(1).word | OutputPins::fan_pin().word),
            "fan_gate sensor_drive(1)");
  EXPECT_EQ(replay::pin_names(OutputPins::heater_supply_pin().word), "heater_supply");
}

}  // namespace
