// SPDX-License-Identifier: Apache-2.0
// What the tools report about a synthesis is reported correctly.
#include "tools/synthesis/report.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace synthesis {
namespace {

constexpr const char* cells = R"({"design": {"num_cells_by_type": {"LUT4": 7000, "PFUMX": 9}}})";
constexpr const char* layout = R"({
  "fmax": {"clk": {"achieved": 60.0, "constraint": 50.0}},
  "utilization": {
    "TRELLIS_COMB": {"available": 80000, "used": 14000},
    "TRELLIS_FF": {"available": 80000, "used": 6000},
    "DP16KD": {"available": 200, "used": 34},
    "MULT18X18D": {"available": 150, "used": 5}},
  "critical_paths": [
    {"from": "<async>", "to": "posedge clk", "path": []},
    {"from": "posedge clk", "to": "posedge clk", "path": [
      {"delay": 5.5, "from": {"cell": "ram", "port": "CLK"}, "to": {"cell": "ram", "port": "DOA"}},
      {"delay": 2.5, "from": {"cell": "ram", "port": "DOA"}, "to": {"cell": "ff", "port": "DI"}}]}]
})";

constexpr const char* ice40_cells = R"({"design": {"num_cells_by_type": {
  "SB_LUT4": 6300, "SB_CARRY": 600, "SB_DFF": 200, "SB_DFFE": 700, "SB_DFFESR": 100}}})";
constexpr const char* ice40_layout = R"({
  "fmax": {"clk$SB_IO_IN_$glb_clk": {"achieved": 52.5, "constraint": 50.0}},
  "utilization": {
    "ICESTORM_LC": {"available": 7680, "used": 6800},
    "ICESTORM_RAM": {"available": 32, "used": 20}},
  "critical_paths": [
    {"from": "negedge clk$SB_IO_IN_$glb_clk", "to": "posedge clk$SB_IO_IN_$glb_clk", "path": [
      {"delay": 9.5,
       "from": {"cell": "ram", "port": "RCLKN"}, "to": {"cell": "lc", "port": "I0"}}]}]
})";

class SynthesisReport : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& cells_text, const std::string& layout_text) const {
    std::ofstream(folder_ / "cells.json") << cells_text;
    std::ofstream(folder_ / "report.json") << layout_text;
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / "stepfabric_synthesis_report_test";
};

TEST_F(SynthesisReport, reports_what_the_tools_have_written) {
  write(cells, layout);
  const Report report = read_report(folder_, folder_, Family::ecp5);
  EXPECT_EQ(report.lut4, 7000);
  EXPECT_EQ(report.logic_cells.used, 14000);
  EXPECT_EQ(report.block_rams.available, 200);
  EXPECT_EQ(report.multipliers.used, 5);
  EXPECT_TRUE(report.fast_enough());
  EXPECT_NEAR(report.margin_percent(), 20, 1e-9);
  ASSERT_EQ(report.critical_path.size(), 2u);
  EXPECT_EQ(report.critical_path.back().to, "ff.DI");
  const auto object = nlohmann::json::parse(as_json(report));
  EXPECT_EQ(object.at("registers").at("used"), 6000);
  EXPECT_EQ(object.at("critical_path").at(0).at("delay_ns"), 5.5);
  EXPECT_NE(as_table(report).find("60.0 MHz; 50 MHz are wanted: +20 %"), std::string::npos);
}

TEST_F(SynthesisReport, knows_the_parts_of_an_ice40) {
  write(ice40_cells, ice40_layout);
  Report report = read_report(folder_, folder_, Family::ice40);
  EXPECT_EQ(report.lut4, 6300);
  EXPECT_EQ(report.registers.used, 1000);
  EXPECT_EQ(report.registers.available, 7680);
  EXPECT_EQ(report.block_rams.used, 20);
  EXPECT_EQ(report.multipliers.available, 0);
  EXPECT_EQ(report.critical_path.front().from, "ram.RCLKN");
  report.board = "core";
  report.device = "hx8k";
  report.memory_bytes = 4096;
  const std::string table = as_table(report);
  EXPECT_TRUE(table.starts_with("core with an iCE40 hx8k, 4 KiB of memory\n")) << table;
  EXPECT_NE(table.find("block RAM of 4 kbit"), std::string::npos) << table;
  EXPECT_EQ(table.find("multipliers"), std::string::npos) << table;
  const auto object = nlohmann::json::parse(as_json(report));
  EXPECT_EQ(object.at("family"), "iCE40");
  EXPECT_EQ(object.at("memory_bytes"), 4096);
  EXPECT_THROW(read_report(folder_, folder_, Family::ecp5), std::runtime_error);
}

TEST_F(SynthesisReport, reports_the_clock_of_each_placement) {
  write(cells, layout);
  Report report = read_report(folder_, folder_, Family::ecp5);
  report.placements = {{.seed = 4, .fastest_mhz = 60.04}};
  EXPECT_EQ(as_table(report).find("of the placements"), std::string::npos);
  report.placements.push_back({.seed = 5, .fastest_mhz = 58.5});
  EXPECT_NE(as_table(report).find("60.0 (seed 4) 58.5 (seed 5) MHz"), std::string::npos);
  const auto object = nlohmann::json::parse(as_json(report));
  EXPECT_EQ(object.at("placements").at(1).at("seed"), 5);
  EXPECT_EQ(object.at("placements").at(1).at("fastest_mhz"), 58.5);
  EXPECT_EQ(object.at("has_debug"), false);
}

TEST_F(SynthesisReport, is_too_slow_below_the_wanted_clock) {
  std::string slow = layout;
  slow.replace(slow.find("60.0"), 4, "49.9");
  write(cells, slow);
  EXPECT_FALSE(read_report(folder_, folder_, Family::ecp5).fast_enough());
}

constexpr const char* layout_with_pins = R"({
  "fmax": {"clk": {"achieved": 60.0, "constraint": 50.0}},
  "utilization": {
    "IOLOGIC": {"available": 128, "used": 12}, "SIOLOGIC": {"available": 69, "used": 6},
    "TRELLIS_COMB": {"available": 80000, "used": 14000},
    "TRELLIS_FF": {"available": 80000, "used": 6000},
    "DP16KD": {"available": 200, "used": 34},
    "MULT18X18D": {"available": 150, "used": 5}},
  "critical_paths": [
    {"from": "<async>", "to": "posedge clk", "path": [
      {"delay": 1.5, "from": {"cell": "i", "port": "O"}, "to": {"cell": "a", "port": "M"}},
      {"delay": 2.5, "from": {"cell": "a", "port": "M"}, "to": {"cell": "a", "port": "M"}}]},
    {"from": "posedge clk", "to": "<async>", "path": [
      {"delay": 9.0, "from": {"cell": "b", "port": "Q"}, "to": {"cell": "o", "port": "I"}}]},
    {"from": "<async>", "to": "<async>", "path": [
      {"delay": 99.0, "from": {"cell": "i", "port": "O"}, "to": {"cell": "o", "port": "I"}}]}]
})";

TEST_F(SynthesisReport, compares_the_pins_with_the_constraints) {
  write(cells, layout_with_pins);
  EXPECT_TRUE(read_report(folder_, folder_, Family::ecp5).pins_are_good());
  const auto good = [this](const char* wanted) {
    std::ofstream(folder_ / "pins.json") << wanted;
    return read_report(folder_, folder_, Family::ecp5).pins_are_good();
  };
  EXPECT_TRUE(
      good(R"({"pad_registers": 18, "input_to_register_ns": 4, "register_to_output_ns": 9.0})"));
  EXPECT_FALSE(
      good(R"({"pad_registers": 19, "input_to_register_ns": 4, "register_to_output_ns": 9.0})"));
  EXPECT_FALSE(
      good(R"({"pad_registers": 18, "input_to_register_ns": 3.9, "register_to_output_ns": 9.0})"));
  EXPECT_FALSE(
      good(R"({"pad_registers": 18, "input_to_register_ns": 4, "register_to_output_ns": 8.9})"));
  const Report report = read_report(folder_, folder_, Family::ecp5);
  EXPECT_NE(as_table(report).find("registers in pads            18; 18 are wanted"),
            std::string::npos)
      << as_table(report);
  EXPECT_EQ(nlohmann::json::parse(as_json(report)).at("pins").at("input_to_register_ns"), 4.0);
}

TEST_F(SynthesisReport, asks_of_every_clock_what_it_must_reach) {
  const std::string two = layout;
  const std::string one = R"("fmax": {"clk": {"achieved": 60.0, "constraint": 50.0})";
  const auto with = [&](const char* other) {
    std::string text = two;
    text.replace(text.find(one), one.size(), one + ", " + other);
    write(cells, text);
    return read_report(folder_, folder_, Family::ecp5);
  };
  const Report good = with(R"("a_watch": {"achieved": 200.0, "constraint": 2.4})");
  EXPECT_EQ(good.wanted_mhz, 50);
  EXPECT_EQ(good.fastest_mhz, 60);
  EXPECT_TRUE(good.fast_enough());
  const Report slow = with(R"("a_watch": {"achieved": 2.0, "constraint": 2.4})");
  EXPECT_FALSE(slow.fast_enough());
  EXPECT_NE(as_table(slow).find("too slow: clock a_watch"), std::string::npos);
}

TEST_F(SynthesisReport, refuses_a_report_that_lacks_something) {
  write("{}", layout);
  EXPECT_THROW(read_report(folder_, folder_, Family::ecp5), std::runtime_error);
  write(cells, R"({"fmax": {}, "utilization": {}, "critical_paths": []})");
  EXPECT_THROW(read_report(folder_, folder_, Family::ecp5), std::runtime_error);
}

}  // namespace
}  // namespace synthesis
