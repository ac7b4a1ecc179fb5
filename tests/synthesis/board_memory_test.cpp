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
  take_boards_with_a_cyclone();
  options_.board = "de2_115";
  options_.memory_bytes = 120 * 1024;
  const std::string complaint = complaint_of([this] { run(); });
  EXPECT_THAT(complaint, testing::HasSubstr("more than 3 banks"));
  EXPECT_THAT(complaint, testing::EndsWith("choose memory_kib = 128"));
}

// Before Yosys has counted for minutes.
TEST_F(SynthesisJob, refuses_a_memory_that_a_cyclone_has_no_room_for_at_once) {
  take_boards_with_a_cyclone();
  options_.memory_bytes = 128 * 1024;
  for (const char* pins : {"", "reprap_2012"}) {
    options_.board = "de2_70";
    options_.pins = pins;
    EXPECT_THAT(complaint_of([this] { run(); }),
                testing::EndsWith("choose de2_115 or ulx3s, or a smaller memory_kib"));
  }
  EXPECT_EQ(text_of("calls"), "");
  options_.pins.clear();
  options_.board = "de2_115";
  EXPECT_EQ(complaint_of([this] { run(); }), "");
}

TEST_F(SynthesisJob, of_all_boards_leaves_out_what_is_not_possible_before_it_starts) {
  take_boards_with_a_cyclone();
  options_.board = "";
  options_.all = true;
  options_.seed = 2;
  options_.debug = true;
  options_.machine = "delta.toml";
  options_.memory_bytes = 128 * 1024;
  testing::internal::CaptureStderr();
  EXPECT_FALSE(run());
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::StartsWith("de2_70 is left out: 128 KiB of memory"));
  const std::string calls = text_of("calls");
  // Of any size: it need not fit into the memory of the core.
  EXPECT_THAT(calls, testing::HasSubstr(" core - "));
  EXPECT_THAT(calls, testing::HasSubstr(" de2_115 firmware.elf "));
  EXPECT_EQ(nlohmann::json::parse(text_of("out/boards.json")).size(), 3u);
}

}  // namespace
}  // namespace synthesis
