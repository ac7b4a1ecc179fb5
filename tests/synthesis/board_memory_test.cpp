// SPDX-License-Identifier: Apache-2.0
// The chip's memory on a board is as large as the machine's firmware needs, or the call says why it
// cannot be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "synthesis_job.hpp"

namespace synthesis {
namespace {

// What the error says, or nothing.
std::string complaint_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST_F(SynthesisJob, makes_a_chip_with_the_memory_that_a_machine_needs) {
  options_.seed = 2;
  EXPECT_TRUE(run());
  EXPECT_NE(text_of("calls").find("-gmemory_size_bytes=106496"), std::string::npos);
  options_.memory_bytes = 131072;
  options_.device = "45k";
  EXPECT_TRUE(run());
  EXPECT_NE(text_of("calls").find("-gmemory_size_bytes=131072"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text_of("out/synthesis.json")).at("memory_bytes"), 131072);
}

TEST_F(SynthesisJob, names_the_devices_with_enough_block_ram) {
  options_.memory_bytes = 131072;
  options_.device = "25k";
  EXPECT_EQ(complaint_of([this] { run(); }),
            "128 KiB of memory are 64 block RAMs, and a 25k has 56: choose --device 45k or 85k");
  // Nothing is left for the chip's queues.
  options_.memory_bytes = 56 * 2048;
  EXPECT_NE(complaint_of([this] { run(); }), "");
  options_.memory_bytes = 220 * 1024;
  options_.device = "45k";
  EXPECT_TRUE(complaint_of([this] { run(); }).ends_with("choose --device 85k"));
}

TEST_F(SynthesisJob, refuses_firmware_for_a_chip_with_another_memory) {
  write_script("pack_bitstream.sh", "#!/bin/sh\ncp \"$1\" \"$4\"\n");
  options_.seed = 2;
  EXPECT_TRUE(run());
  options_.firmware_only = true;
  EXPECT_TRUE(run());
  options_.memory_bytes = 131072;
  EXPECT_THAT(complaint_of([this] { run(); }),
              testing::HasSubstr("has 104 KiB of memory, and the firmware is for 128"));
}

TEST_F(SynthesisJob, refuses_a_memory_of_more_banks_than_a_cyclone_has) {
  std::filesystem::create_directories(folder_ / "boards/de2_115");
  std::ofstream(folder_ / "boards/de2_115/device.csv");
  options_.board = "de2_115";
  options_.memory_bytes = 120 * 1024;
  EXPECT_THAT(complaint_of([this] { run(); }), testing::HasSubstr("more than 3 banks"));
}

}  // namespace
}  // namespace synthesis
