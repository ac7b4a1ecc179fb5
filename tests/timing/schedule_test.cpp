// SPDX-License-Identifier: Apache-2.0
// The analysis of the schedule against cyclic executives that are run: where it says that a
// deadline holds none is missed, and just where it says that one does not, there is a run that
// misses it.
#include "tools/timing/schedule.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "tests/timing/executive.hpp"

namespace timing {
namespace {

constexpr std::uint32_t baud_rates[] = {9'600, 115'200, 250'000, 1'000'000, 3'000'000};

// Bounds of tasks between a clock and so many.
Load random_load(std::mt19937& random, Clocks most) {
  std::uniform_int_distribution<Clocks> clocks(1, most);
  Load load;
  Clocks sum = 0;
  for (std::size_t task = 0; task < units::task_count; ++task) {
    load.begins[task] = sum;
    sum += clocks(random);
    load.ends[task] = sum;
    load.tasks[task] = sum - *load.begins[task];
  }
  load.pass = sum + clocks(random);
  return load;
}

// With a FIFO and hosts that make it overflow.
Facts random_facts(std::mt19937& random) {
  Facts facts;
  facts.receive_depth = std::uniform_int_distribution<std::uint64_t>(100, 2'000)(random);
  facts.unanswered_bytes = std::uniform_int_distribution<std::uint64_t>(80, 4'000)(random);
  facts.sleep_ms = std::uniform_int_distribution<std::uint64_t>(0, 10)(random);
  return facts;
}

template <class Number>
Number one_of(std::mt19937& random, std::initializer_list<Number> numbers) {
  return *(numbers.begin() +
           std::uniform_int_distribution<std::size_t>(0, numbers.size() - 1)(random));
}

constexpr std::uint32_t clocks_hz[] = {1'000'000, 4'000'000, 25'000'000};

struct Setting {
  explicit Setting(std::mt19937& random)
      : facts(random_facts(random)),
        load(random_load(random, one_of<Clocks>(random, {300, 3'000, 30'000}))),
        rate{clocks_hz[random() % std::size(clocks_hz)],
             one_of<std::uint32_t>(random, {115'200, 250'000, 1'000'000})} {}

  std::optional<std::uint64_t> longest(Requirement requirement, const Passes& run) const {
    return longest_in(requirement, facts, load, rate, run);
  }

  // What a pass brings, in looks.
  double growth() const {
    const double bytes =
        static_cast<double>(*load.pass) * rate.baud * 1.03 / (10.0 * rate.clock_hz);
    return bytes / static_cast<double>(facts.bytes_of_a_look);
  }

  Facts facts;
  Load load;
  Rate rate;
};

TEST(Schedule, no_run_is_worse_than_the_analysis_says) {
  std::mt19937 random(7);
  for (int round = 0; round < 5'000; ++round) {
    const Setting setting(random);
    const Passes run = random_run(setting.facts, setting.load, setting.rate, random);
    for (const Response& response : respond(setting.facts, setting.load, setting.rate)) {
      const auto found = setting.longest(response.requirement, run);
      if (!found) continue;
      const bool is_within =
          response.is_least ? *found >= *response.worst : *found <= *response.worst;
      ASSERT_TRUE(is_within) << response.text() << ", but a run came to " << *found;
      if (response.holds && !response.is_least) {
        ASSERT_LE(*found, response.allowed) << response.text();
      }
    }
  }
}

// Phases within a clock, and within a tick of the clock, are not chosen by it.
std::uint64_t slack_of(Requirement requirement, Rate rate) {
  const Clocks ms = rate.clock_hz / 1000;
  switch (requirement) {
    case Requirement::received_bytes:
      return 1;
    case Requirement::sign_of_life:
      return ms + 2;
    case Requirement::heater_watchdog:
      return 2 * ms + 2;
    case Requirement::not_too_early:
      return 3 * ms + 200;
    default:
      return 2;
  }
}

TEST(Schedule, the_worst_run_comes_to_what_the_analysis_says) {
  std::mt19937 random(8);
  for (int round = 0; round < 5'000; ++round) {
    const Setting setting(random);
    const Passes run = worst_run(setting.facts, setting.load, setting.rate);
    for (const Response& response : respond(setting.facts, setting.load, setting.rate)) {
      const auto found = setting.longest(response.requirement, run);
      if (!found) continue;
      const bool piles_up_slowly = setting.growth() > 1 && setting.growth() < 1.05;
      if (response.requirement <= Requirement::stop_by_host && piles_up_slowly) continue;
      const std::uint64_t slack = slack_of(response.requirement, setting.rate);
      if (response.is_least) {
        ASSERT_LE(*found, *response.worst + slack) << response.text();
      } else {
        ASSERT_GE(*found + slack, *response.worst) << response.text();
        if (response.holds) {
          ASSERT_LE(*found, response.allowed) << response.text();
        }
      }
    }
  }
}

// At four fifths of it, which is farther than any slack.
void expect_a_miss_well_below(Requirement requirement, const Facts& facts, const Load& load,
                              Rate rate) {
  const Rate slower{rate.clock_hz / 5 * 4 / 1000 * 1000, rate.baud};
  const Passes run = worst_run(facts, load, slower);
  const auto found = longest_in(requirement, facts, load, slower, run);
  if (!found) return;
  const Response response = respond(requirement, facts, load, slower);
  if (response.is_least) {
    EXPECT_LT(*found, response.allowed) << response.text();
  } else {
    EXPECT_GT(*found, response.allowed) << response.text();
  }
}

TEST(Schedule, below_the_lowest_clock_and_above_the_highest_something_is_missed) {
  std::mt19937 random(9);
  int lowest = 0, highest = 0;
  for (unsigned round = 0; round < 300; ++round) {
    const Load load = random_load(random, one_of<Clocks>(random, {1'000, 10'000, 50'000}));
    const Facts facts;
    const std::uint32_t baud = baud_rates[round % std::size(baud_rates)];
    const ClockRange range = clocks_that_hold(facts, load, baud);
    const auto all_hold = [&](std::uint32_t hz) {
      return std::ranges::all_of(respond(facts, load, {hz, baud}),
                                 [](const Response& response) { return response.holds; });
    };
    if (range.is_empty()) {
      EXPECT_FALSE(all_hold(range.lowest_hz));
      EXPECT_FALSE(all_hold(range.highest_hz));
      continue;
    }
    EXPECT_TRUE(all_hold(range.lowest_hz));
    EXPECT_TRUE(all_hold(range.highest_hz));
    EXPECT_TRUE(all_hold(range.lowest_hz / 2 + range.highest_hz / 2));
    if (range.slower_fails) {
      ++lowest;
      expect_a_miss_well_below(*range.slower_fails, facts, load, {range.lowest_hz, baud});
      for (std::uint32_t below = 1; below < 50; ++below) {
        const Rate rate{range.lowest_hz - below, baud};
        EXPECT_FALSE(respond(*range.slower_fails, facts, load, rate).holds) << below;
      }
    }
    if (range.faster_fails) {
      ++highest;
      EXPECT_FALSE(respond(*range.faster_fails, facts, load, {range.highest_hz + 1, baud}).holds);
    }
  }
  EXPECT_GT(lowest, 100);
  EXPECT_GT(highest, 100);
}

// By hand, at 4 MHz: a pass of 10 000 clocks, bytes of 40 clocks at 1 Mbaud.
TEST(Schedule, of_a_small_example_is_that_by_hand) {
  Facts facts;
  facts.fast_sender_percent = 100;
  facts.unanswered_bytes = 10'000;
  Load load{.pass = 5'000, .begins = {}, .ends = {}, .tasks = {}, .line = {}};
  load.ends[static_cast<std::size_t>(units::Task::serial_line)] = 1'000;
  const auto worst = [&](Requirement requirement, std::uint32_t baud) {
    return *respond(requirement, facts, load, {4'000'000, baud}).worst;
  };
  // 6000 clocks are 150 bytes, and one that ends in their first clock.
  EXPECT_EQ(worst(Requirement::received_bytes, 1'000'000), 151u);
  facts.receive_depth = 151;
  EXPECT_TRUE(respond(Requirement::received_bytes, facts, load, {4'000'000, 1'000'000}).holds);
  facts.receive_depth = 150;
  EXPECT_FALSE(respond(Requirement::received_bytes, facts, load, {4'000'000, 1'000'000}).holds);
  load.pass = 5'161;  // brings more than the 129 of a look
  EXPECT_EQ(worst(Requirement::received_bytes, 1'000'000), 10'000u);
  load.pass = 5'000;
  load.ends[0] = 500;
  // Sleep: 8 ms.
  EXPECT_EQ(worst(Requirement::motion_watchdog, 1'000'000), 5'000u + 32'000 + 500 + 1);
  // 101 ms, twice a pass and a sleep, and a pass.
  EXPECT_EQ(worst(Requirement::heater_watchdog, 1'000'000),
            404'000u + 2 * (5'000 + 32'000) + 5'000 + 1);
}

TEST(Schedule, of_four_mhz_and_three_megabaud_is_refused) {
  Load load;
  const Response bits = respond(Requirement::bits, {}, load, {4'000'000, 3'000'000});
  EXPECT_TRUE(bits.is_bounded);
  EXPECT_FALSE(bits.holds);
  EXPECT_TRUE(respond(Requirement::bits, {}, load, {12'000'000, 3'000'000}).holds);
  load.pass = 1;
  EXPECT_EQ(clocks_that_hold({}, load, 3'000'000).lowest_hz, 12'000'000u);
}

TEST(Schedule, without_a_bound_nothing_holds_but_the_lines_speed) {
  for (const Response& response : respond({}, {}, {50'000'000, 250'000})) {
    const bool is_bits = response.requirement == Requirement::bits;
    EXPECT_EQ(response.holds, is_bits);
    EXPECT_EQ(response.is_bounded, is_bits);
    if (is_bits) continue;
    EXPECT_THAT(response.text(), testing::HasSubstr("not bounded"));
  }
}

}  // namespace
}  // namespace timing
