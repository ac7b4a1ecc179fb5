// SPDX-License-Identifier: Apache-2.0
// A machine description from a user's file is refused with the entry, its line and what it may be.
#include "sim/machine/description.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// What is said about this text; empty where it is a machine.
std::string complaint(const std::string& text) {
  const fs::path file = fs::path(testing::TempDir()) / "described_machine.toml";
  std::ofstream(file) << text;
  std::string said;
  try {
    machine::read_description(file);
  } catch (const std::runtime_error& error) {
    said = error.what();
  }
  fs::remove(file);
  return said;
}

// The same about the given machine with one text replaced by another.
std::string complaint(const std::string& from, const std::string& to) {
  std::ifstream stream(PROJECT_DIRECTORY "/firmware/machines/prusa_mendel.toml");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return complaint(text.replace(at, from.size(), to));
}

TEST(Description, takes_the_given_machine_and_one_without_jerk) {
  EXPECT_EQ(complaint("", ""), "");
  EXPECT_EQ(complaint("jerk_mm_s = 10.0", "jerk_mm_s = 0.0"), "");
}

TEST(Description, names_what_is_missing) {
  EXPECT_THAT(complaint("name = \"half\"\nkinematics = \"cartesian\"\n"),
              HasSubstr("described_machine.toml: line 1: serial: is missing"));
}

// Each of these was simulated, or ended the program by a signal.
TEST(Description, names_what_the_chip_cannot_be_or_has_not) {
  EXPECT_THAT(complaint("baud = 250_000", "baud = 0"),
              HasSubstr("line 9: serial.baud: is 0, but must be 1200 to"));
  EXPECT_THAT(complaint("heater_channel = 0", "heater_channel = 40"),
              HasSubstr("hotend.heater_channel: is 40, but must be 0 to 3"));
  EXPECT_THAT(complaint("sensor_channel = 0", "sensor_channel = 9"),
              HasSubstr("hotend.sensor_channel: is 9, but must be 0 to 3"));
  EXPECT_THAT(complaint("endstop = 2", "endstop = 77"),
              HasSubstr("axes.z.endstop: is 77, but must be 0 to 7"));
}

TEST(Description, names_what_it_does_not_know) {
  EXPECT_THAT(complaint("baud = 250_000", "baud = 250_000\nparity = 1"),
              HasSubstr("line 10: serial.parity: is not an entry"));
}

}  // namespace
