// SPDX-License-Identifier: Apache-2.0
// The analysis of the schedule against loops that are run by the rule: no response is longer,
// motion never ends, and some runs are nearly as bad.
#include "tools/timing/schedule.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "tests/timing/executive.hpp"
#include "tools/timing/rounds.hpp"

namespace timing {
namespace {

using units::Task;

constexpr std::uint32_t baud_rates[] = {9'600, 115'200, 250'000, 1'000'000, 3'000'000};

Clocks random_part(std::mt19937& random, Clocks most) {
  return std::uniform_int_distribution<Clocks>(0, most)(random);
}

std::size_t index_of(Task task) { return static_cast<std::size_t>(task); }

// Bounds of tasks between a clock and so many; the small ones are small.
Load random_load(std::mt19937& random, Clocks most) {
  const auto clocks = [&](Clocks part) { return 1 + random_part(random, most / part); };
  Load load{.pass = {},
            .tasks = {},
            .start = clocks(40),
            .gaps = {},
            .line = clocks(4),
            .refill_without_line = clocks(40)};
  for (auto& task : load.tasks) task = clocks(1);
  for (auto& gap : load.gaps) gap = clocks(40);
  load.tasks[index_of(Task::motion)] = clocks(40);
  load.tasks[index_of(Task::rest)] = clocks(40);
  load.tasks[index_of(Task::refill)] =
      *load.refill_without_line + *load.line + random_part(random, 3 * *load.line);
  load.pass = load.start;
  for (const auto& task : load.tasks) *load.pass += *task;
  for (const auto& gap : load.gaps) *load.pass += *gap;
  return load;
}

constexpr std::uint32_t clocks_hz[] = {1'000'000, 4'000'000, 25'000'000};
constexpr Task waiting_tasks[] = {Task::serial_line, Task::faults,  Task::heat,
                                  Task::planning,    Task::reports, Task::commands};
constexpr Requirement of_motion[] = {Requirement::allowances, Requirement::reserve,
                                     Requirement::margin,     Requirement::gain,
                                     Requirement::horizon,    Requirement::queue};

// A machine whose lines are just so long that motion goes on.
struct Setting {
  explicit Setting(std::mt19937& random)
      : load(random_load(random, std::array<Clocks, 3>{300, 3'000, 30'000}[random() % 3])),
        rate{clocks_hz[random() % std::size(clocks_hz)], 250'000} {
    const auto some = [&](Clocks most) { return random_part(random, most); };
    facts.sleep_ms = some(10);
    facts.waiting_lines = 1 + some(80);
    facts.lines_of_a_round = some(3);
    facts.lines_of_a_refill = 2 + some(4);
    facts.horizon_ms = 1'000'000;
    const Clocks gain = *respond(Requirement::gain, facts, load, rate).worst;
    facts.least_line_clocks = gain / facts.lines_of_a_refill + 1 + some(2) * some(*load.line);
    for (const Task task : waiting_tasks) {
      facts.allowances[index_of(task)] = *load.tasks[index_of(task)] + some(1) * some(100);
    }
    facts.refill_reserve = *respond(Requirement::reserve, facts, load, rate).worst;
    facts.refill_margin = *respond(Requirement::margin, facts, load, rate).worst;
    const Clocks in_hand = *respond(Requirement::queue, facts, load, rate).worst;
    facts.lines_of_a_pass = in_hand / facts.least_line_clocks + 1 + some(1) * some(3);
    const Clocks queue = facts.lines_of_a_pass * facts.least_line_clocks;
    if (some(1) == 0) facts.horizon_ms = queue / (rate.clock_hz / 1000) + 1;
  }

  Run run(std::size_t rounds, bool sleeps, const Choice& choice) const {
    return Executive(facts, load, rate, choice).rounds(rounds, sleeps);
  }
  Clocks served(Task task, std::uint64_t looks) const {
    return time_of_rounds(looks, facts, load) + *load.tasks[index_of(task)];
  }

  Facts facts;
  Load load;
  Rate rate;
};

// Of each time often all or nothing.
Choice at_random(std::mt19937& random) {
  const auto none = random() % 4, all = none + random() % 4;
  return [&random, none, all](Clocks most) {
    const auto choice = random() % 8;
    return choice < none ? 0 : choice < all ? most : random_part(random, most);
  };
}

const Choice at_worst = [](Clocks most) { return most; };

TEST(Schedule, no_run_is_worse_than_the_analysis_says) {
  std::mt19937 random(7);
  for (int round = 0; round < 2'000; ++round) {
    const Setting setting(random);
    for (const Requirement requirement : of_motion) {
      const Response response = respond(requirement, setting.facts, setting.load, setting.rate);
      ASSERT_TRUE(response.holds) << response.text();
    }
    for (const bool sleeps : {false, true}) {
      const Choice choice = round % 4 == 0 ? at_worst : at_random(random);
      const timing::Run run = setting.run(9, sleeps, choice);
      ASSERT_FALSE(run.motion_has_ended) << round;
      ASSERT_LE(run.put_off, put_off_in(9, setting.facts, setting.load));
      ASSERT_LE(run.longest_pass, *setting.load.pass);
      for (const Task task : waiting_tasks) ASSERT_GE(run.tasks[index_of(task)].size(), 9u);
      if (sleeps) continue;
      for (const Task task : waiting_tasks) {
        for (std::size_t looks = 1; looks < 9; ++looks) {
          ASSERT_LE(run.longest_response(task, looks), setting.served(task, looks)) << looks;
        }
      }
      ASSERT_LE(run.longest_of_two_rounds(), time_of_rounds(2, setting.facts, setting.load));
    }
  }
}

TEST(Schedule, no_feeding_of_the_heaters_watchdog_is_later_or_sooner_than_the_analysis_says) {
  std::mt19937 random(10);
  for (int round = 0; round < 300; ++round) {
    const Setting setting(random);
    const Choice choice = round % 4 == 0 ? at_worst : at_random(random);
    const auto feeds = Executive(setting.facts, setting.load, setting.rate, choice).feeds(3'000);
    const auto of = [&](Requirement requirement) {
      return respond(requirement, setting.facts, setting.load, setting.rate);
    };
    ASSERT_LE(feeds.longest, *of(Requirement::heater_watchdog).worst) << round;
    ASSERT_GE(feeds.shortest, *of(Requirement::not_too_early).worst) << round;
  }
}

TEST(Schedule, some_runs_are_nearly_as_bad_as_the_analysis_says) {
  std::mt19937 random(8);
  double nearest = 0;
  for (int round = 0; round < 2'000; ++round) {
    const Setting setting(random);
    const timing::Run run = setting.run(4, false, at_worst);
    const auto found = static_cast<double>(run.longest_response(Task::serial_line, 1));
    nearest = std::max(nearest, found / static_cast<double>(setting.served(Task::serial_line, 1)));
  }
  EXPECT_GT(nearest, 0.85);
}

// Of 1000 machines, in how many such a change lets motion end, or a task wait for too long.
struct Misses {
  int motion{}, tasks{};
};
Misses misses_with(const std::function<void(Setting&)>& change) {
  std::mt19937 random(11);
  Misses misses;
  for (int round = 0; round < 1'000; ++round) {
    Setting setting(random);
    change(setting);
    const timing::Run run =
        setting.run(2, round % 2 == 0, round % 4 < 2 ? at_worst : at_random(random));
    if (run.motion_has_ended) ++misses.motion;
    if (run.put_off > put_off_in(2, setting.facts, setting.load)) ++misses.tasks;
  }
  return misses;
}

TEST(Schedule, each_number_of_the_rule_is_needed) {
  const Misses none = misses_with([](Setting&) {});
  EXPECT_EQ(none.motion, 0);
  EXPECT_EQ(none.tasks, 0);
  EXPECT_GT(misses_with([](Setting& s) { s.facts.refill_reserve /= 2; }).motion, 10);
  EXPECT_GT(misses_with([](Setting& s) {
              s.facts.lines_of_a_pass -= s.facts.refill_margin / s.facts.least_line_clocks + 1;
              s.facts.refill_margin = 0;
            }).tasks,
            0);
  EXPECT_GT(misses_with([](Setting& s) {
              s.facts.least_line_clocks = s.facts.least_line_clocks * 3 / 4;
            }).motion,
            10);
  EXPECT_GT(misses_with([](Setting& s) {
              for (auto& allowance : s.facts.allowances) {
                if (allowance != 0) allowance = 1;
              }
            }).motion,
            10);
}

TEST(Schedule, below_the_lowest_clock_and_above_the_highest_something_is_missed) {
  std::mt19937 random(9);
  int lowest = 0, highest = 0;
  for (unsigned round = 0; round < 300; ++round) {
    const Setting setting(random);
    Facts facts = setting.facts;
    facts.horizon_ms = Facts().horizon_ms;
    facts.refill_reserve += 1'000;
    const Load& load = setting.load;
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
  EXPECT_GT(lowest, 50);
  EXPECT_GT(highest, 50);
}

// By hand, at 4 MHz.
TEST(Schedule, of_a_small_example_is_that_by_hand) {
  Facts facts;
  facts.allowances = {};
  facts.allowances[index_of(Task::serial_line)] = 2'000;
  facts.allowances[index_of(Task::commands)] = 4'000;
  facts.waiting_lines = 5;
  facts.lines_of_a_round = 1;
  facts.least_line_clocks = 400;
  facts.refill_reserve = 1'000;
  facts.refill_margin = 500;
  Load load{
      .pass = 6'000, .tasks = {}, .start = 10, .gaps = {}, .line = 500, .refill_without_line = 100};
  load.tasks.fill(0);
  load.gaps.fill(10);
  load.tasks[index_of(Task::motion)] = 60;
  load.tasks[index_of(Task::serial_line)] = 1'000;
  load.tasks[index_of(Task::commands)] = 3'000;
  load.tasks[index_of(Task::refill)] = 1'200;
  load.tasks[index_of(Task::rest)] = 200;
  // Both tasks may have to wait: 3500 clocks are in hand then, of which the first leaves 2490.
  EXPECT_EQ(waits_in(1, facts, load), 2u);
  // Two tasks with their gaps; 5 passes that take 400 clocks each, 6 lines, and two full passes.
  EXPECT_EQ(time_of_rounds(1, facts, load), 4'020u + 5 * 400 + 6 * 500 + 2 * 1'500);
  const auto worst = [&](Requirement requirement) {
    return *respond(requirement, facts, load, {4'000'000, 1'000'000}).worst;
  };
  EXPECT_EQ(worst(Requirement::emergency_stop), 12'020u);
  EXPECT_EQ(worst(Requirement::stop_settled), 12'020u);
  EXPECT_EQ(worst(Requirement::allowances), 3'000u);
  // 3 us, a gap, a pass, and two lines behind one another, of which the first lasts 400 clocks.
  EXPECT_EQ(worst(Requirement::reserve), 12u + 10 + 300 + (100 + 1'000) - 400);
  EXPECT_EQ(worst(Requirement::margin), 12u + 300 + 100 + 500);
  EXPECT_EQ(worst(Requirement::gain), 300u + 1'200);
  EXPECT_EQ(worst(Requirement::queue), 3'000u + facts.refill_reserve + facts.refill_margin);
  EXPECT_EQ(worst(Requirement::horizon), 10u * 400);
  // Sleep: 8 ms.
  EXPECT_EQ(worst(Requirement::motion_watchdog), 6'000u + 32'000 + 10 + 60 + 1);
  // 101 ms, twice a round and a sleep, and a pass.
  EXPECT_EQ(worst(Requirement::heater_watchdog), 404'000u + 2 * (12'020 + 32'000) + 6'000 + 1);
  EXPECT_EQ(worst(Requirement::received_bytes), 9u * 130);
}

TEST(Schedule, of_four_mhz_and_three_megabaud_is_refused) {
  Load load;
  const Response bits = respond(Requirement::bits, {}, load, {4'000'000, 3'000'000});
  EXPECT_TRUE(bits.is_bounded);
  EXPECT_FALSE(bits.holds);
  EXPECT_TRUE(respond(Requirement::bits, {}, load, {12'000'000, 3'000'000}).holds);
  load = {.pass = 1, .tasks = {}, .start = 1, .gaps = {}, .line = 1, .refill_without_line = 1};
  load.tasks.fill(1);
  load.gaps.fill(1);
  EXPECT_EQ(clocks_that_hold({}, load, 3'000'000).lowest_hz, 12'000'000u);
}

TEST(Schedule, without_a_bound_nothing_holds_but_the_lines_speed) {
  for (const Response& response : respond({}, {}, {50'000'000, 250'000})) {
    const bool is_bits = response.requirement == Requirement::bits;
    EXPECT_EQ(response.holds, is_bits);
    EXPECT_EQ(response.is_bounded, is_bits);
    if (!is_bits) {
      EXPECT_THAT(response.text(), testing::HasSubstr("not bounded"));
    }
  }
}

}  // namespace
}  // namespace timing
