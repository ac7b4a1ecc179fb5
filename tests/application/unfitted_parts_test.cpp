// SPDX-License-Identifier: Apache-2.0
// What sliced files request of parts that this printer does not have, and guards that can be
// switched off.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

TEST(unfitted_parts, are_named_and_the_print_goes_on) {
  Printer printer;
  printer.talk(R"(
    -> M906 X800
    <- echo:M906 not fitted
    <- ok
    -> M569 S1 X
    <- echo:M569 not fitted
    <- ok
    -> m0412 s1
    <- echo:M412 not fitted
    <- ok
    -> M862.3 P "MK3S" ; printer model
    <- echo:M862 not fitted
    <- ok
    -> M862.7
    <- echo:Unknown command: "M862.7"
    <- ok
    -> M300 S440 P200
    <- ok
    -> M121
    <- ok
  )");
  EXPECT_EQ(printer.counters.commands_refused, 1u);
}

// Moves and heats nothing.
TEST(unfitted_parts, of_all_kinds_are_answered_in_the_same_way) {
  Printer printer;
  for (const std::string code :
       {"G29",  "G30",  "M42",  "M143", "M217", "M218", "M226", "M240", "M280", "M301", "M303",
        "M304", "M412", "M413", "M420", "M425", "M569", "M572", "M575", "M593", "M603", "M605",
        "M665", "M666", "M701", "M702", "M851", "M900", "M906", "M907", "M913", "M914"}) {
    printer.talk("-> " + code + " S200 X10 Y10 Z5 E1 P0\n<- echo:" + code + " not fitted\n<- ok");
  }
  EXPECT_EQ(printer.counters.commands_refused, 2u);  // G29 and G30 would have moved
  printer.run(0.5);
  EXPECT_EQ(printer.chip.motors, 0u);
  EXPECT_EQ(printer.chip.heater_duty(0), 0u);
}

TEST(unfitted_parts, are_refused_where_a_person_would_rely_on_them) {
  Printer printer;
  printer.talk(R"(
    -> M500
    <- echo:EEPROM disabled, not executed: "M500"
    <- ok
    -> M504
    <- echo:EEPROM disabled, not executed: "M504"
    <- ok
    -> M120
    <- echo:End stops end homing only, not executed: "M120"
    <- ok
  )");
}

// From whatever slicer.
TEST(names_of_objects, are_passed_over_with_one_notice) {
  Printer printer;
  printer.talk(R"(
    -> EXCLUDE_OBJECT_DEFINE NAME=part_1 CENTER=100,100 POLYGON=[[95,95],[105,105]]
    <- echo:Names of objects are ignored
    <- ok
    -> exclude_object_start name=part_1
    <- ok
    -> M486 S0
    <- ok
    -> M486 A"the part"
    <- ok
    -> EXCLUDE_OBJECT_END NAME=part_1
    <- ok
    -> M486 P0
    <- echo:Objects cannot be left out, not executed: "M486 P0"
    <- ok
    -> EXCLUDE_OBJECT NAME=part_1
    <- echo:Objects cannot be left out, not executed: "EXCLUDE_OBJECT NAME=part_1"
    <- ok
    -> EXCLUDE_OBJEC
    <- echo:Unknown command: "EXCLUDE_OBJEC"
    <- ok
  )");
}

TEST(cold_extrusion, is_as_m302_says) {
  Printer printer;
  printer.run(1);
  printer.talk(R"(
    -> M302
    <- echo:Cold extrudes are disabled (min temp 170C)
    <- ok
    -> G1 E1 F600
    <- echo: cold extrusion prevented
    <- ok
    -> M302 P1
    <- ok
    -> M302
    <- echo:Cold extrudes are enabled (min temp 170C)
    <- ok
    -> G1 E2
    <- ok
    -> M302 S15
    <- ok
    -> G1 E4
    <- ok
    -> M302 S180
    <- ok
    -> G1 E5
    <- echo: cold extrusion prevented
    <- ok
    -> M302 S0
    <- ok
    -> G1 E6
    <- ok
    -> M400
    <- ok
  )");
  EXPECT_EQ(printer.chip.position[3], 2000);  // 1, 2 and 1 mm
}

TEST(inactivity, halts_after_the_time_of_m85) {
  Printer printer;
  printer.talk("-> M85\n<- echo:M85 S0\n<- ok\n-> M85 S30\n<- ok");
  printer.run(29);
  printer.talk("-> G91\n<- ok");  // a word counts
  EXPECT_FALSE(printer.reply(29).has_value());
  printer.talk("<* KILL caused by too much inactive time\n<* kill() called");
}

}  // namespace
}  // namespace application_test
