// SPDX-License-Identifier: Apache-2.0
// Lines that a host sends for a dry run are not executed.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

TEST(dry_run_commands, executes_nothing_behind_the_bit_of_the_dry_run) {
  Printer printer;
  printer.talk(R"(
    -> M111 S14
    <- echo:No dry run, nothing is executed until M111 S0, not executed: "M111 S14"
    <- ok
    -> G28
    <- echo:No dry run, nothing is executed until M111 S0, not executed: "G28"
    <- ok
    -> M104 S200
    <- echo:No dry run, nothing is executed until M111 S0, not executed: "M104 S200"
    <- ok
    -> M9999
    <- echo:No dry run, nothing is executed until M111 S0, not executed: "M9999"
    <- ok
    -> M111
    <- echo:DEBUG:DRYRUN, nothing is executed until M111 S0
    <- ok
    -> M105
    <* ok T:
    -> M110 N3
    <- ok
  )");
  EXPECT_EQ(printer.chip.motors, 0u);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
  EXPECT_EQ(printer.counters.commands_refused, 4u);
  // Any S without the bit.
  printer.talk(R"(
    -> M111 S6
    <- ok
    -> M17
    <- ok
  )");
  EXPECT_NE(printer.chip.motors, 0u);
}

// Marlin cuts the number to a byte.
TEST(dry_run_commands, takes_a_number_beyond_the_bits_as_all_of_them) {
  Printer printer;
  printer.talk(R"(
    -> M111 S256
    <- echo:No dry run, nothing is executed until M111 S0, not executed: "M111 S256"
    <- ok
    -> M111 S-8
    <- ok
    -> M118 on
    <- on
    <- ok
  )");
}

TEST(dry_run_commands, takes_the_bits_of_messages) {
  Printer printer;
  printer.talk(R"(
    -> M111
    <- echo:DEBUG:off
    <- ok
    -> M111 S7
    <- ok
    -> M118 on
    <- on
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 0u);
}

TEST(dry_run_commands, executes_nothing_in_a_simulation) {
  Printer printer;
  printer.talk(R"(
    -> M37 S1
    <- echo:No simulation, nothing is executed until M37 S0, not executed: "M37 S1"
    <- ok
    -> G28
    <- echo:No simulation, nothing is executed until M37 S0, not executed: "G28"
    <- ok
    -> M37
    <- echo:No simulation, nothing is executed until M37 S0, not executed: "M37"
    <- ok
    -> M37 S0
    <- ok
    -> M17
    <- ok
  )");
  EXPECT_NE(printer.chip.motors, 0u);
  EXPECT_EQ(printer.counters.commands_refused, 3u);
}

// The simulation of a file ends with the file, and the lines after it are to be executed.
TEST(dry_run_commands, goes_on_behind_a_refused_simulation_of_a_file) {
  Printer printer;
  printer.talk(R"(
    -> M37 P"part.g"
    <- echo:No simulation, not executed: "M37 P"part.g""
    <- ok
    -> M37
    <- echo:No simulation, not executed: "M37"
    <- ok
    -> M118 on
    <- on
    <- ok
  )");
}

TEST(dry_run_commands, has_a_dry_run_and_a_simulation_end_each_by_its_own_command) {
  Printer printer;
  printer.talk(R"(
    -> M37 S1
    <* No simulation
    <- ok
    -> M111 S8
    <* No dry run
    <- ok
    -> M37 S0
    <- ok
    -> G28
    <- echo:No dry run, nothing is executed until M111 S0, not executed: "G28"
    <- ok
    -> M37 S2
    <* No dry run
    <- ok
    -> M111 S0
    <- ok
    -> G28
    <- echo:No simulation, nothing is executed until M37 S0, not executed: "G28"
    <- ok
  )");
  EXPECT_EQ(printer.chip.motors, 0u);
}

// Lines of a file to be stored are not executed, not even M111 S0.
TEST(dry_run_commands, does_not_end_by_a_line_of_a_file_to_be_stored) {
  Printer printer;
  printer.talk(R"(
    -> M111 S8
    <* No dry run
    <- ok
    -> M28 part.gco
    <- echo:No SD card until M29, not executed: "M28 part.gco"
    <- ok
    -> M111 S0
    <- echo:No SD card until M29, not executed: "M111 S0"
    <- ok
    -> M29
    <- echo:No SD card, not executed: "M29"
    <- ok
    -> G28
    <- echo:No dry run, nothing is executed until M111 S0, not executed: "G28"
    <- ok
  )");
  EXPECT_EQ(printer.chip.motors, 0u);
}

// These hold on after it.
TEST(dry_run_commands, follows_units_and_files_in_a_dry_run) {
  Printer printer;
  printer.talk(R"(
    -> M111 S8
    <* No dry run
    <- ok
    -> M149 F
    <- ok
    -> M23 part.gco
    <* No SD card
    <- ok
    -> M111 S0
    <- ok
    -> M149
    <- echo: M149 F ; Units in Fahrenheit
    <- ok
    -> M24
    <- echo:No SD card, not executed: "M24"
    <- ok
  )");
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
}

}  // namespace
}  // namespace application_test
