// SPDX-License-Identifier: Apache-2.0
// The workloads of `bench processor` compute known results.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

#include "directories.hpp"
#include "firmware/benchmark/checksum.hpp"
#include "firmware/benchmark/core_work.hpp"
#include "firmware/benchmark/linked_list.hpp"
#include "firmware/benchmark/parser_work.hpp"
#include "firmware/benchmark/planner_work.hpp"
#include "tools/benchmark/processor_figures.hpp"

namespace {

using benchmark::LinkedList;

TEST(processor_works, the_checksum_is_crc_16) {
  std::uint16_t sum = 0;
  for (const char character : {'1', '2', '3', '4', '5', '6', '7', '8', '9'}) {
    sum = benchmark::add_byte(sum, static_cast<std::uint8_t>(character));
  }
  EXPECT_EQ(sum, 0xBB3D);  // the check value of CRC-16/ARC
}

TEST(processor_works, that_do_not_exist_are_named_before_anything_is_measured) {
  const auto say = [](const std::string& what) { ADD_FAILURE() << what << " is measured"; };
  try {
    benchmarks::measure_processor({.programs = {}, .examples = {}, .works = {"core", "foo"}}, say);
    FAIL() << "nothing was said of foo";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "there is no work foo: name core, record, parser or planner");
  }
}

TEST(processor_works, the_list_keeps_its_records_and_sorts_them) {
  LinkedList list;
  list.fill(7);
  const auto before = list.checksum();
  list.sort_by_value();
  const auto lowest = list.first_value();
  EXPECT_NE(list.checksum(), before);
  list.reverse();
  EXPECT_GT(list.first_value(), lowest);
  EXPECT_EQ(list.find(LinkedList::length), nullptr);
  ASSERT_NE(list.find(17), nullptr);
  EXPECT_EQ(list.find(17)->place, 17);
  list.sort_by_place();
  EXPECT_EQ(list.checksum(), before);
}

TEST(processor_works, what_core_computes_depends_on_every_iteration) {
  std::set<std::uint32_t> sums;
  for (std::uint32_t iterations = 1; iterations <= 8; ++iterations) {
    const auto work = std::make_unique<benchmark::CoreWork>();
    work->prepare({});
    sums.insert(work->run(iterations).checksum);
  }
  EXPECT_EQ(sums.size(), 8u);
}

TEST(processor_works, moves_are_taken_from_the_middle_of_a_sliced_file) {
  const auto text = benchmarks::moves_of(PROJECT_DIRECTORY "/examples/washer.gcode", 2000);
  EXPECT_GT(text.size(), 1900u);
  EXPECT_LE(text.size(), 2000u);
  EXPECT_TRUE(text.starts_with("G1 "));
  EXPECT_TRUE(text.ends_with("\n"));
  EXPECT_FALSE(text.contains(';'));
}

TEST(processor_works, the_parser_reads_every_line_and_the_planner_plans_every_move) {
  constexpr std::string_view text =
      "G1 X10 Y10 F3000\nG1 X20.5 Y10\nG1 X20.5 Y12.25\nG1 X10 Y10 E1\n";
  benchmark::ParserWork parser;
  parser.prepare(text);
  EXPECT_EQ(parser.run(3).units, 12u);
  const auto planner = std::make_unique<benchmark::PlannerWork>();
  planner->prepare(text);
  EXPECT_EQ(planner->run(2).units, 2 * 6u);  // three moves there, three back
}

}  // namespace
