// SPDX-License-Identifier: Apache-2.0
// The Quartus project of each board with a Cyclone is complete and consistent, as far as stand-ins
// for Quartus' commands can tell, and mistakes that are put into one are found.
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

#include "directories.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace synthesis {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const fs::path project = PROJECT_DIRECTORY;

// What the stand-ins say: a line for each complaint, and at the end what they have seen.
std::vector<std::string> complaints_of(const fs::path& folder, const std::string& board,
                                       const fs::path& tables) {
  // Yosys brings the Tcl.
  const std::string call = fs::path(testing::TempDir()) / "stepfabric quartus call.tcl";
  std::ofstream(call) << "set argv [list {" << folder.string() << "} {" << (tables / board).string()
                      << "}]\nsource {" << (project / "tests/synthesis/check_project.tcl").string()
                      << "}\n";
  const auto [status, text] =
      process::capture({.arguments = {"yosys", "-q", "-Q", "-T", "-c", call}});
  std::vector<std::string> lines;
  std::istringstream stream(text);
  bool is_whole = false;
  for (std::string line; std::getline(stream, line);) {
    is_whole |= line.starts_with("checked ");
    if (line.starts_with("complaint: ")) lines.push_back(line.substr(11));
  }
  if (status != 0 || !is_whole) lines.push_back("the check has failed: " + text);
  return lines;
}

// In place of the firmware: more than the memory's first bank holds, no two neighbours the same.
std::string image() {
  std::string bytes(70'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(7 * i + i / 256);
  return bytes;
}

// The sources of one are made by GHDL once, of each board.
fs::path project_of(const std::string& board) {
  static std::map<std::string, fs::path> made;
  if (const auto found = made.find(board); found != made.end()) return found->second;
  const fs::path folder = fs::path(testing::TempDir()) / ("stepfabric quartus " + board);
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string binary = folder / "image.bin", program = folder / "image.elf";
  std::ofstream(binary) << image();
  const auto [status, text] = process::capture(
      {.arguments = {"sh", "-c",
                     "riscv64-unknown-elf-objcopy -I binary -O elf32-littleriscv \"$1\" \"$2\" && "
                     "\"$3/tools/hardware/write_quartus_project.sh\" \"$3\" \"$4\" \"$2\" \"$5\"",
                     "sh", binary, program, project.string(), board, folder.string()}});
  EXPECT_EQ(status, 0) << text;
  return made.emplace(board, folder).first->second;
}

class QuartusProject : public testing::Test {
 protected:
  explicit QuartusProject(std::string board = "de2_115") : board_(std::move(board)) {}
  void SetUp() override {
    fs::remove_all(copy_);
    fs::create_directories(copy_ / board_);
    fs::copy(project_of(board_), copy_ / "project");
    for (const char* table : {"pins.csv", "banks.csv", "device.csv"}) {
      fs::copy(project / "boards" / board_ / table, copy_ / board_ / table);
    }
    ASSERT_THAT(complaints(), IsEmpty());
  }
  void TearDown() override { fs::remove_all(copy_); }

  std::vector<std::string> complaints() const {
    return complaints_of(copy_ / "project", board_, copy_);
  }
  void replace(const fs::path& file, const std::string& old_text,
               const std::string& new_text) const {
    std::string text = files::text_of(copy_ / file);
    const std::size_t place = text.find(old_text);
    ASSERT_NE(place, std::string::npos) << old_text;
    text.replace(place, old_text.size(), new_text);
    std::ofstream(copy_ / file) << text;
  }
  // Puts a mistake in, looks for it, and takes it out.
  void expect_found(const fs::path& file, const std::string& good, const std::string& bad,
                    const std::string& complaint) const {
    replace(file, good, bad);
    EXPECT_THAT(complaints(), Contains(HasSubstr(complaint)));
    if (!bad.empty()) replace(file, bad, good);
  }

  const std::string board_;
  const fs::path pins_ = "project/pins.tcl", timing_ = "project/" + board_ + ".sdc",
                 maker_ = "project/make_project.tcl";
  const fs::path copy_ = fs::path(testing::TempDir()) / "stepfabric quartus copy";
};

TEST_F(QuartusProject, of_the_other_boards_is_good_too) {
  for (const char* board : {"de2_70", "de2_70_reprap_2012"}) {
    EXPECT_THAT(complaints_of(project_of(board), board, project / "boards"), IsEmpty()) << board;
  }
}

// The contents of a file, in the order of its addresses.
std::string contents_of(const fs::path& file, std::size_t words) {
  std::istringstream text(files::text_of(file));
  std::string line;
  while (std::getline(text, line) && line != "CONTENT BEGIN") {
  }
  std::string bytes;
  while (std::getline(text, line) && line != "END;") {
    std::size_t address = 0;
    unsigned byte = 0;
    EXPECT_EQ(std::sscanf(line.c_str(), " %zX : %x;", &address, &byte), 2) << line;
    EXPECT_EQ(address, bytes.size());
    bytes += static_cast<char>(byte);
  }
  EXPECT_EQ(bytes.size(), words) << file;
  return bytes;
}

TEST_F(QuartusProject, holds_the_program_in_one_file_for_each_byte_of_a_word) {
  constexpr std::array<std::size_t, 3> bank_words{65536 / 4, 32768 / 4, 8192 / 4};
  std::string whole = image();
  whole.resize(4 * std::accumulate(bank_words.begin(), bank_words.end(), std::size_t{0}));
  for (std::size_t lane = 0; lane < 4; ++lane) {
    std::string expected;
    for (std::size_t i = lane; i < whole.size(); i += 4) expected += whole[i];
    std::string found;
    for (std::size_t bank = 0; bank < bank_words.size(); ++bank) {
      found += contents_of(
          copy_ / "project" /
              ("bank" + std::to_string(bank + 1) + "_lane" + std::to_string(lane + 1) + ".mif"),
          bank_words[bank]);
    }
    EXPECT_EQ(found, expected) << "lane " << lane + 1;
  }
}

TEST_F(QuartusProject, with_a_pin_twice_or_none_is_found) {
  expect_found(pins_, "PIN_A14 -to {clock_25mhz}", "PIN_Y2 -to {clock_25mhz}",
               "clock_25mhz and clock_50mhz share PIN_Y2");
  expect_found(pins_, "PIN_A14 -to {clock_25mhz}", "PIN_ZZ9 -to {clock_25mhz}",
               "the board has no PIN_ZZ9");
  expect_found(pins_, "PIN_A14 -to {clock_25mhz}", "PIN_A14 -to {clock_26mhz}",
               "there is no port clock_26mhz");
  replace(pins_, "set_location_assignment PIN_G9 -to {uart_txd}\n", "");
  EXPECT_THAT(complaints(), Contains("uart_txd has no pin"));
}

TEST_F(QuartusProject, with_another_voltage_than_the_banks_is_found) {
  expect_found(pins_, "IO_STANDARD \"2.5 V\" -to {led[0]}",
               "IO_STANDARD \"3.3-V LVTTL\" -to {led[0]}", "led[0] wants 3.3 V in bank 7 of 2.5 V");
  expect_found("de2_115/banks.csv", "4,3.3", "4,2.5", "step[0] wants 3.3 V in bank 4 of 2.5 V");
}

TEST_F(QuartusProject, with_a_wrong_io_standard_or_none_is_found) {
  const std::string good =
      "set_instance_assignment -name IO_STANDARD \"3.3-V LVTTL\" -to {uart_txd}\n";
  expect_found(pins_, good,
               "set_instance_assignment -name IO_STANDARD \"3.3-V LVTTL2\" -to {uart_txd}\n",
               "uart_txd: IO_STANDARD is {3.3-V LVTTL2}");
  // A standard that exists, of another voltage than the port's bank.
  expect_found(pins_, good, "set_instance_assignment -name IO_STANDARD \"2.5 V\" -to {uart_txd}\n",
               "uart_txd wants 2.5 V in bank");
  expect_found(pins_, good, good + good, "uart_txd: IO_STANDARD is said twice");
  replace(pins_, good, "");
  EXPECT_THAT(complaints(), Contains("uart_txd has no I/O standard"));
}

TEST_F(QuartusProject, with_a_port_left_out_or_with_two_pins_is_found) {
  const std::string good = "set_location_assignment PIN_A14 -to {clock_25mhz}\n";
  expect_found(pins_, good, good + "set_location_assignment PIN_G9 -to {clock_25mhz}\n",
               "clock_25mhz has two pins");
  replace(pins_, good, "");
  EXPECT_THAT(complaints(), Contains("clock_25mhz has no pin"));
}

TEST_F(QuartusProject, with_a_wrong_assignment_is_found) {
  expect_found(pins_, "WEAK_PULL_UP_RESISTOR", "WEAK_PULL_RESISTOR", "no WEAK_PULL_RESISTOR");
  expect_found(pins_, "\"8MA\"", "\"9MA\"", "CURRENT_STRENGTH_NEW is 9MA");
  expect_found(pins_, "-to {led[0]}", "-to \"led[0]\"", "Tcl: invalid command name \"0\"");
  expect_found(maker_, "EP4CE115F29C7", "EP4CE115F29C8", "DEVICE is EP4CE115F29C8");
  expect_found(maker_, "-name FAMILY", "-nmae FAMILY", "no option -nmae");
  expect_found(maker_, "DONT_CARE OFF", "DONT_CARE ON", "ALLOW_POWER_UP_DONT_CARE is ON");
  expect_found(maker_, "MIF_FILE bank1_lane1.mif", "MIF_FILE bank1_lane9.mif",
               "there is no bank1_lane9.mif");
  expect_found(maker_, "export_assignments", "export_assignment", "Tcl: invalid command");
}

// The erratum of its block RAM with two clocks.
class QuartusProjectOfCycloneII : public QuartusProject {
 protected:
  QuartusProjectOfCycloneII() : QuartusProject("de2_70") {}

  const std::string safe_ = "set_parameter -name CYCLONEII_SAFE_WRITE VERIFIED_SAFE\n";
};

TEST_F(QuartusProjectOfCycloneII, says_that_the_memory_is_safe) {
  const std::string refused = "CYCLONEII_SAFE_WRITE is not VERIFIED_SAFE";
  expect_found(maker_, safe_, "# nothing in its place\n", refused);
  expect_found(maker_, "VERIFIED_SAFE", "PORT_SWAP", refused);
  expect_found(maker_, "VERIFIED_SAFE", "VERIFIED", "CYCLONEII_SAFE_WRITE is VERIFIED");
  expect_found(maker_, "CYCLONEII_SAFE_WRITE", "CYCLONE_SAFE_WRITE", "set_parameter: no such name");
  expect_found(maker_, safe_, safe_ + safe_, "CYCLONEII_SAFE_WRITE is said twice");
  expect_found(maker_, "set_parameter -name", "set_parameter -entity memory -name",
               "CYCLONEII_SAFE_WRITE is wanted for all cells");
}

TEST_F(QuartusProjectOfCycloneII, with_a_port_a_that_writes_is_found) {
  expect_found("project/memory_lane.v", ".wren_a(1'b0)", ".wren_a(data_write)",
               "memory_lane.v: port A may write");
}

TEST_F(QuartusProject, of_a_cyclone_iv_has_nothing_of_the_cyclone_ii) {
  EXPECT_THAT(files::text_of(copy_ / maker_), Not(HasSubstr("CYCLONEII")));
  expect_found(maker_, "source pins.tcl\n",
               "set_parameter -name CYCLONEII_SAFE_WRITE VERIFIED_SAFE\nsource pins.tcl\n",
               "CYCLONEII_SAFE_WRITE is for a Cyclone II, not for a Cyclone IV E");
}

TEST_F(QuartusProject, with_a_file_left_out_is_found) {
  replace(maker_, "set_global_assignment -name VERILOG_FILE memory.v\n", "");
  EXPECT_THAT(complaints(), Contains("memory.v is not in the project"));
}

TEST_F(QuartusProject, with_a_clock_or_pin_without_timing_is_found) {
  replace(timing_, "create_clock -name clock_50mhz -period 20.000 [get_ports {clock_50mhz}]\n", "");
  EXPECT_THAT(complaints(), Contains("clock_50mhz has no timing constraint"));
  replace(timing_, "set_max_delay -from [get_ports {end_stop[3]}] -to [all_registers] 15\n", "");
  EXPECT_THAT(complaints(), Contains("end_stop[3] has no timing constraint"));
  replace(timing_, "derive_pll_clocks\n", "");
  EXPECT_THAT(complaints(), Contains(HasSubstr("derive_pll")));
}

TEST_F(QuartusProject, with_an_input_delay_in_place_of_a_clocks_period_is_found) {
  expect_found(timing_, "create_clock -name clock_50mhz -period 20.000 [get_ports {clock_50mhz}]",
               "set_max_delay -from [get_ports {clock_50mhz}] -to [all_registers] 15",
               "clock_50mhz is a clock without a period");
}

TEST_F(QuartusProject, with_a_period_of_another_frequency_is_found) {
  for (const char* period : {"-period 20.020", "-period 200.000", "-period 2.000"}) {
    expect_found(timing_, "-period 20.000", period, "clock_50mhz has a period of");
  }
}

TEST_F(QuartusProject, that_takes_two_oscillators_as_one_is_found) {
  replace(timing_, "set_clock_groups -asynchronous -group [get_clocks {clock_25mhz}]\n", "");
  EXPECT_THAT(complaints(),
              Contains("clock_25mhz clock_50mhz are taken as clocks of one oscillator"));
}

TEST_F(QuartusProject, with_a_wrong_timing_constraint_is_found) {
  expect_found(timing_, "-period 20.000", "-period fast", "create_clock: period fast");
  expect_found(timing_, "[get_clocks {clock_25mhz}]", "[get_clocks {clock_24mhz}]",
               "there is no clock clock_24mhz");
  expect_found(timing_, "-to [get_ports {fan_gate}]", "-from [get_ports {fan_gate}]",
               "set_max_delay -from fan_gate, which is no input");
}

}  // namespace
}  // namespace synthesis
