// SPDX-License-Identifier: Apache-2.0
// A machine description from a user's file is refused with the entry, its line and what it may be.
#include "sim/machine/description.hpp"

#include <gmock/gmock.h>

#include "tests/sim/changed_description.hpp"

namespace {

using testing::HasSubstr;

std::string complaint(const std::string& text) {
  return tests::complaint_of(machine::read_description, text);
}

// About the default machine with one text replaced by another.
std::string complaint(const std::string& from, const std::string& to) {
  return complaint(tests::changed_description(from, to));
}

void expect_complaints(std::initializer_list<tests::Mistake> mistakes) {
  tests::expect_complaints_of(machine::read_description, mistakes);
}

TEST(Description, takes_the_given_machine_and_one_without_jerk) {
  EXPECT_EQ(complaint("", ""), "");
  EXPECT_EQ(complaint("jerk_mm_s = 10.0", "jerk_mm_s = 0.0"), "");
}

TEST(Description, names_what_is_missing) {
  EXPECT_THAT(complaint("name = \"half\"\nkinematics = \"cartesian\"\n"),
              HasSubstr("changed_machine.toml: line 1: serial: is missing"));
}

// Each of these was simulated, or ended the program by a signal.
TEST(Description, names_what_the_chip_cannot_be_or_has_not) {
  expect_complaints(
      {{"baud = 250_000", "baud = 0", "line 9: serial.baud: is 0, but must be 1200 to"},
       {"heater_channel = 0", "heater_channel = 40",
        "hotend.heater_channel: is 40, but must be 0 to 3"},
       {"sensor_channel = 0", "sensor_channel = 9",
        "hotend.sensor_channel: is 9, but must be 0 to 3"},
       {"endstop = 2", "endstop = 77", "axes.z.endstop: is 77, but must be 0 to 7"}});
}

TEST(Description, names_what_it_does_not_know) {
  expect_complaints({{"baud = 250_000", "baud = 250_000\nparity = 1",
                      "line 10: serial.parity: is not an entry"}});
}

// A chip may have four, the simulated one has two.
TEST(Description, names_channels_that_the_simulated_chip_does_not_have) {
  expect_complaints({{"heater_channel = 0", "heater_channel = 2",
                      "hotend.heater_channel: is 2, but the simulated chip has 0 to 1"},
                     {"sensor_channel = 1", "sensor_channel = 3",
                      "bed.sensor_channel: is 3, but the simulated chip has 0 to 1"}});
}

TEST(Description, may_hold_any_language_in_comments_and_ascii_elsewhere) {
  EXPECT_EQ(complaint("jerk_mm_s = 10.0", "jerk_mm_s = 10.0 # \xC3\xBC \xF0\x9F\x98\x80 \"'"), "");
  expect_complaints({{"name = \"Prusa Mendel\"", "name = \"M\xC3\xBCller\"",
                      "line 5: holds a character outside ASCII"},
                     {"baud = 250_000", "\xC3\xA9 = 1", "outside ASCII"},
                     {"baud = 250_000", "baud = \xC2\xA1", "outside ASCII"}});
  // What looks like a comment in a text of several lines is none.
  expect_complaints({{"baud = 250_000", "baud = '''\n# ''' \xC3\xA9", "text of several lines"}});
}

}  // namespace
