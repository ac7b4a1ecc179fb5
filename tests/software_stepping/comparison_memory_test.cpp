// SPDX-License-Identifier: Apache-2.0
// An image that is larger than the chip's memory prints by software stepping, and there only.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "directories.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/benchmark/printing_run.hpp"

namespace {

constexpr std::uint32_t memory_start = 0x8000'0000;

// The whole firmware with its variables behind code that fills the chip's memory.
class ComparisonMemory : public testing::Test {
 protected:
  const sim::ElfImage image_ = sim::read_elf(BUILD_DIRECTORY "/firmware/filled_software.elf");
};

std::string complaint_of_load(const sim::ElfImage& image, sim::VerilatedChip& chip) {
  try {
    sim::load(image, chip);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST_F(ComparisonMemory, takes_an_image_that_the_chip_has_no_room_for_and_prints_with_it) {
  ASSERT_GE(image_.symbol("_bss_start"), memory_start + CHIP_MEMORY_BYTES);
  // Each ramp takes 5000 ticks: it is within an outer quarter.
  const benchmarks::Printing printing{
      .interval_clocks = 1000, .ticks_per_line = 500, .lines = 56, .axes = 4};
  const auto run = benchmarks::run_printing(
      image_, machine::read_description(PROJECT_DIRECTORY "/firmware/machines/benchmark.toml"),
      printing, {.quick = true});
  EXPECT_EQ(run.fault(printing), "") << run.complaint;
  EXPECT_EQ(run.pins[0].rises.size(), 500U * 56);
}

TEST_F(ComparisonMemory, is_not_that_of_the_chip) {
  for (const sim::Processor processor : {sim::Processor::model, sim::Processor::netlist}) {
    sim::VerilatedChip chip(4'000'000, sim::Edges::leaping, processor);
    EXPECT_THAT(complaint_of_load(image_, chip), testing::HasSubstr("the program does not fit"));
  }
}

TEST_F(ComparisonMemory, is_not_that_of_the_netlist_either_where_it_steps_in_software) {
  sim::VerilatedChip chip(4'000'000, sim::Edges::leaping, sim::Processor::netlist);
  chip.permit_software_stepping();
  EXPECT_THAT(complaint_of_load(image_, chip), testing::HasSubstr("the program does not fit"));
}

}  // namespace
