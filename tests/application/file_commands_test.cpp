// SPDX-License-Identifier: Apache-2.0
// What hosts ask of a card, which is not there.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

// There is no card: what would be stored on it is not a print either.
TEST(file_commands, executes_nothing_between_m28_and_m29) {
  Printer printer;
  printer.talk(R"(
    -> M28 part.gco
    <- echo:No SD card until M29, not executed: "M28 part.gco"
    <- ok
    -> G28
    <- echo:No SD card until M29, not executed: "G28"
    <- ok
    -> M104 S200
    <- echo:No SD card until M29, not executed: "M104 S200"
    <- ok
    -> M105
    <* ok T:
    -> M114
    <* X:
    <- ok
    -> M119
    <- Reporting endstop status
    <* x_min
    <* y_min
    <* z_min
    <- ok
    -> M110 N3
    <- ok
    -> M29 part.gco
    <- echo:No SD card, not executed: "M29 part.gco"
    <- ok
    -> M118 on
    <- on
    <- ok
  )");
  EXPECT_EQ(printer.chip.motors, 0u);
  EXPECT_EQ(printer.counters.commands_refused, 4u);
}

// A host that comes into the middle of it gets online.
TEST(file_commands, says_what_it_is_between_m28_and_m29) {
  Printer printer;
  printer.talk(R"(
    -> M28 part.gco
    <- echo:No SD card until M29, not executed: "M28 part.gco"
    <- ok
    -> M115
    <* FIRMWARE_NAME:StepFabric
  )");
}

TEST(file_commands, says_that_files_of_a_card_and_repeats_are_not_there) {
  Printer printer;
  printer.talk(R"(
    -> M32 part.gco
    <- echo:No SD card, not executed: "M32 part.gco"
    <- ok
    -> M24
    <- echo:No SD card, not executed: "M24"
    <- ok
    -> M808 L5
    <- echo:No repeats, the lines after it are executed once, not executed: "M808 L5"
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 3u);
}

TEST(file_commands, does_not_go_on_with_m24_where_m23_was_refused) {
  Printer printer;
  printer.talk(R"(
    -> M23 part.gco
    <- echo:No SD card, not executed: "M23 part.gco"
    <- ok
    -> M24
    <- echo:No SD card, not executed: "M24"
    <- ok
    -> M24
    <- //action:resume
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 2u);
}

}  // namespace
}  // namespace application_test
