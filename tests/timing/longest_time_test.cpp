// SPDX-License-Identifier: Apache-2.0
// Bounds of random networks, against all their paths; proofs of them, right and wrong.
#include <gtest/gtest.h>

#include "tests/timing/random_network.hpp"
#include "tests/timing/second_solver.hpp"
#include "tools/timing/longest_time.hpp"
#include "tools/timing/pricing.hpp"
#include "tools/timing/solver.hpp"

namespace timing {
namespace {

using Kind = LongestTime::Kind;

constexpr unsigned tries = 400;

TEST(LongestTime, is_that_of_the_longest_of_all_paths) {
  std::mt19937 random(1);
  unsigned without_path = 0, exact = 0, limited = 0;
  for (unsigned i = 0; i < tries; ++i) {
    const RandomNetwork tried = random_network(random);
    const LongestTime found = longest_time(tried.networks);
    const auto in_integers = optimum_in_integers(program_of(tried.networks));
    ASSERT_EQ(in_integers.has_value(), tried.has_path()) << i;
    if (!tried.has_path()) {
      // Fractions of paths may keep to the facts where no path does.
      ASSERT_TRUE(found.kind == Kind::contradiction || found.kind == Kind::proved) << i;
      without_path += found.kind == Kind::contradiction ? 1U : 0U;
      continue;
    }
    ASSERT_EQ(found.kind, Kind::proved) << i;
    ASSERT_GE(found.clocks, tried.longest()) << i;
    ASSERT_DOUBLE_EQ(*in_integers, static_cast<double>(tried.longest())) << i;
    exact += found.clocks == tried.longest() ? 1U : 0U;
    Networks without = tried.networks;
    without.facts = {{0, ~0U}, {1, ~0U}};
    limited += found.clocks < longest_time(without).clocks ? 1U : 0U;
  }
  EXPECT_GT(without_path, tries / 50);
  EXPECT_GT(exact, tries / 2);
  EXPECT_GT(limited, tries / 10) << "facts that matter";
}

TEST(LongestTime, is_the_same_in_a_reduced_network) {
  std::mt19937 random(2);
  for (unsigned i = 0; i < tries; ++i) {
    Networks networks = random_network(random).networks;
    const LongestTime whole = longest_time(networks);
    const std::size_t arcs = networks.networks[0].arcs.size();
    networks.networks[0].reduce();
    EXPECT_LE(networks.networks[0].arcs.size(), arcs);
    const LongestTime reduced = longest_time(networks);
    ASSERT_EQ(whole.kind, reduced.kind) << i;
    ASSERT_EQ(whole.clocks, reduced.clocks) << i;
  }
}

TEST(LongestTime, is_proved_from_any_prices_and_smallest_from_the_solver_s) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> price(0, 60);
  unsigned larger = 0;
  for (unsigned i = 0; i < tries; ++i) {
    const RandomNetwork tried = random_network(random);
    if (!tried.has_path()) continue;
    const auto best = longest_time(tried.networks).clocks;
    const LinearProgram program = program_of(tried.networks);
    const auto proved = proved_near(tried.networks, program, {price(random), price(random)});
    ASSERT_TRUE(proved);
    ASSERT_GE(*proved, best) << i;
    larger += *proved > best ? 1U : 0U;
    ASSERT_GE(proved_near(tried.networks, program, {-1, 0.0 / 0.0}).value(), best);
  }
  EXPECT_GT(larger, tries / 10) << "wrong prices that matter";
}

TEST(Certificate, a_price_that_is_too_low_proves_nothing) {
  std::mt19937 random(4);
  unsigned refused = 0, lowered = 0;
  for (unsigned i = 0; i < 100; ++i) {
    const RandomNetwork tried = random_network(random);
    if (!tried.has_path()) continue;
    const LinearProgram program = program_of(tried.networks);
    const Prices prices = price(tried.networks, 1, {3, 5});
    ASSERT_TRUE(proved_bound(program, prices));
    for (std::size_t row = 0; row < program.rows.size(); ++row) {
      Prices wrong = prices;
      wrong.of_rows[row] -= 1;
      const auto bound = proved_bound(program, wrong);
      ++lowered;
      refused += bound ? 0U : 1U;
      if (bound) {
        ASSERT_GE(*bound, tried.longest()) << i << " " << row;
      }
    }
  }
  EXPECT_GT(refused, lowered / 2);
}

// A loop of at most 3 rounds of 10 clocks, and the way out.
Networks one_loop() {
  Network network;
  network.end = 1;
  Arc round, exit;
  round.clocks = 10;
  exit.to = 1;
  exit.clocks = 7;
  network.arcs = {round, exit};
  network.loops = {{.header = 0, .nodes = {true}, .most = 3}};
  return {{network}, {}};
}

TEST(Certificate, each_inequality_counts) {
  const LinearProgram program = program_of(one_loop());
  EXPECT_EQ(proved_bound(program, {.scale = 1, .of_rows = {7, 10}}), 37U);
  EXPECT_EQ(proved_bound(program, {.scale = 2, .of_rows = {15, 20}}), 37U) << "rounded down";
  EXPECT_FALSE(proved_bound(program, {.scale = 1, .of_rows = {6, 10}})) << "the way out";
  EXPECT_FALSE(proved_bound(program, {.scale = 1, .of_rows = {7, 9}})) << "a round";
  EXPECT_FALSE(proved_bound(program, {.scale = 1, .of_rows = {7}})) << "a price is missing";
  EXPECT_FALSE(proved_bound(program, {.scale = 0, .of_rows = {7, 10}}));
  LinearProgram free = program;
  for (Column& column : free.columns) column.clocks = 0;
  EXPECT_FALSE(proved_bound(free, {.scale = 1, .of_rows = {0, -1}})) << "a price below 0";
  const Wide huge = Wide{1} << 126;
  EXPECT_FALSE(proved_bound(program, {.scale = 1, .of_rows = {huge, huge}}));
}

TEST(Certificate, a_lost_arc_or_wrong_clocks_are_found) {
  const Networks networks = one_loop();
  const LinearProgram program = program_of(networks);
  Networks wrong = networks;
  wrong.networks[0].arcs[0].clocks -= 1;
  EXPECT_FALSE(proved_bound(program, price(wrong, 1, {})));
  wrong = networks;
  wrong.networks[0].arcs.erase(wrong.networks[0].arcs.begin());
  EXPECT_FALSE(proved_bound(program, price(wrong, 1, {})));
  wrong = networks;
  wrong.networks[0].loops[0].most = 2;
  EXPECT_EQ(proved_bound(program, price(wrong, 1, {})), 37U) << "the prices are the same";
}

TEST(LongestTime, of_what_is_too_long_for_the_numbers_is_not_given) {
  Networks networks = one_loop();
  networks.networks[0].arcs[0].clocks = ~Clocks{0} / 2;
  networks.networks[0].loops[0].most = ~Clocks{0} / 2;
  EXPECT_EQ(longest_time(networks).kind, Kind::too_long);
}

TEST(LongestTime, of_networks_that_are_called_adds_up) {
  // Twice the loop on one way, once and 30 clocks on the other.
  Networks networks;
  Network caller;
  caller.end = 1;
  Arc twice, once;
  twice.to = once.to = 1;
  twice.calls = {1, 1};
  once.calls = {1};
  once.clocks = 30;
  caller.arcs = {twice, once};
  networks.networks = {caller, one_loop().networks[0]};
  EXPECT_EQ(longest_time(networks).clocks, 2U * 37);
  // Of all rounds at most 2: then two ways out, or one and 30 more.
  networks.facts = {{.event = 0, .most = 2}};
  networks.networks[0].entry_begins = {0};
  networks.networks[1].arcs[0].events = {0};
  EXPECT_EQ(longest_time(networks).clocks, 7U + 2 * 10 + 30);
  // With 4 the longest path has 67 clocks; a third of one way and two of the other have 69 1/3.
  networks.facts[0].most = 4;
  EXPECT_EQ(longest_time(networks).clocks, 69U);
  EXPECT_EQ(optimum_in_integers(program_of(networks)), 67);
  // Both ways are places of an event that happens once: one case leaves out the one, one the other.
  networks.facts.push_back({.event = 1, .most = 1});
  networks.networks[0].entry_begins = {0, 1};
  for (Arc& arc : networks.networks[0].arcs) arc.events = {1};
  EXPECT_EQ(longest_time(networks).clocks, 67U);
  networks.facts[1].most = 2;
  EXPECT_EQ(longest_time(networks).clocks, 69U) << "it may happen on both";
  networks.facts[1].most = 1;
  networks.networks[0].entry_begins = {0, 1, 1};
  EXPECT_EQ(longest_time(networks).clocks, 69U) << "there are two runs";
  networks.networks[0].entry_begins = {0};
  networks.networks[1].entry_begins = {1};
  EXPECT_EQ(longest_time(networks).clocks, 69U) << "each of several runs may have it once";
}

}  // namespace
}  // namespace timing
