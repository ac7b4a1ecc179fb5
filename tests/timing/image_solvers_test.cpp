// SPDX-License-Identifier: Apache-2.0
// All functions of the firmware: the proved bound, HiGHS in fractions and GLPK in whole numbers
// are the same, but for a few whose best fractions are no whole numbers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "directories.hpp"
#include "sim/processor/timing_table.hpp"
#include "tests/timing/second_solver.hpp"
#include "tools/timing/analysis.hpp"
#include "tools/timing/certificate.hpp"
#include "tools/timing/longest_time.hpp"
#include "tools/timing/pricing.hpp"
#include "tools/timing/solver.hpp"

namespace timing {
namespace {

// Of sums of some ten thousand columns in floating point.
constexpr double relative_error = 1e-9;
// How much of a bound may be owed to fractions.
constexpr double most_in_fractions = 0.01;

bool is_fraction(double passes) { return std::abs(passes - std::round(passes)) > 1e-6; }

// The clocks of a solution rounded to whole numbers, if it keeps to all rows exactly.
std::optional<Wide> clocks_in_whole_numbers(const LinearProgram& program,
                                            const std::vector<double>& passes) {
  std::vector<Wide> sums(program.rows.size());
  Wide clocks = 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const Wide count = std::llround(passes[i]);
    if (count < 0) return std::nullopt;
    clocks += count * program.columns[i].clocks;
    for (const auto& [row, factor] : program.columns[i].entries) sums[row] += count * factor;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Constraint& row = program.rows[i];
    if (row.is_equation ? sums[i] != row.right_side : sums[i] > row.right_side) return std::nullopt;
  }
  return clocks;
}

TEST(Solvers, agree_on_all_functions_of_the_firmware) {
  Program program = read_program(BUILD_DIRECTORY "/firmware/firmware.elf");
  program.memory_bytes = CHIP_MEMORY_BYTES;
  Analysis analysis(program, Costs{processor::TimingTable()}, CHIP_HAS_ZBB);
  std::size_t compared = 0, in_fractions = 0, with_facts = 0, most_columns = 0;
  for (const auto& [function, symbol] : program.symbols) {
    const auto bound = symbol.size != 0 ? analysis.bound(function) : std::nullopt;
    if (!bound) continue;
    const auto networks = analysis.networks(function);
    ASSERT_TRUE(networks) << symbol.name;
    const LinearProgram linear = program_of(*networks);
    const auto clocks = static_cast<double>(*bound);
    const double error = std::max(1.0, clocks) * relative_error;
    const Solution first = solve(linear);
    ASSERT_EQ(first.kind, Solution::Kind::optimal) << symbol.name;
    const auto second = optimum_in_integers(linear);
    ASSERT_TRUE(second) << symbol.name;
    ++compared;
    if (std::ranges::any_of(first.passes, is_fraction)) {
      // The bound is this without its fraction; a path takes as long, or nearly so.
      EXPECT_EQ(static_cast<double>(*bound), std::floor(first.clocks + error)) << symbol.name;
      EXPECT_LE(*second, clocks + error) << symbol.name;
      EXPECT_GE(*second, clocks * (1 - most_in_fractions)) << symbol.name;
      ++in_fractions;
      continue;
    }
    EXPECT_NEAR(first.clocks, clocks, error) << symbol.name;
    // So the bound is the least: a path of the program takes as long.
    EXPECT_TRUE(clocks_in_whole_numbers(linear, first.passes) == Wide{*bound}) << symbol.name;
    EXPECT_NEAR(*second, clocks, error) << symbol.name;
    with_facts += networks->facts.empty() ? 0U : 1U;
    most_columns = std::max(most_columns, linear.columns.size());
  }
  EXPECT_GT(compared, 250U);
  EXPECT_LE(in_fractions, 3U);
  fmt::print("{} functions, {} of them with facts; up to {} columns\n", compared, with_facts,
             most_columns);
}

// Prices of a network without one of its arcs prove nothing too small of the whole one.
TEST(Solvers, prices_that_miss_an_arc_of_the_firmware_are_refused) {
  Program program = read_program(BUILD_DIRECTORY "/firmware/firmware.elf");
  program.memory_bytes = CHIP_MEMORY_BYTES;
  Analysis analysis(program, Costs{processor::TimingTable()}, CHIP_HAS_ZBB);
  std::mt19937 random(1);
  std::size_t tried = 0, refused = 0;
  for (const auto& [function, symbol] : program.symbols) {
    const auto bound = symbol.size != 0 ? analysis.bound(function) : std::nullopt;
    if (!bound) continue;
    const Networks networks = analysis.networks(function).value();
    const LinearProgram linear = program_of(networks);
    const std::vector<Wide> no_prices(networks.facts.size());
    for (int i = 0; i < 5; ++i) {
      Networks wrong = networks;
      auto& arcs = wrong.networks[0].arcs;
      std::uniform_int_distribution<std::ptrdiff_t> place(0, std::ssize(arcs) - 1);
      arcs.erase(arcs.begin() + place(random));
      const auto proved = proved_bound(linear, price(wrong, 1, no_prices));
      ++tried;
      refused += proved ? 0U : 1U;
      if (proved) {
        EXPECT_GE(*proved, *bound) << symbol.name;
      }
    }
  }
  EXPECT_GT(refused, tried / 5);
  fmt::print("{} of {} refused\n", refused, tried);
}

}  // namespace
}  // namespace timing
