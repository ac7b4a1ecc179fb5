// SPDX-License-Identifier: Apache-2.0
// The timer of the print, by the fake chip's time.
#include <gtest/gtest.h>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

TEST(timer_commands, count_from_m75_to_m77_but_for_pauses) {
  Printer printer;
  printer.talk("-> M31\n<- echo:Print time: 0s\n<- ok\n-> M75\n<- ok");
  printer.run(3725.5);
  printer.talk("-> M31\n<- echo:Print time: 1h 2m 5s\n<- ok\n-> M76\n<- ok");
  printer.run(100);
  printer.talk("-> M31\n<- echo:Print time: 1h 2m 5s\n<- ok\n-> M75\n<- ok");
  printer.run(60);
  printer.talk("-> M77\n<- ok");
  printer.run(30);
  printer.talk(R"(
    -> M31
    <- echo:Print time: 1h 3m 5s
    <- ok
    -> M78
    <- Stats: Prints: 1, Finished: 1, Failed: 0
    <- Stats: Total time: 1h 3m 5s, Longest job: 1h 3m 5s
    <- ok
    -> M78 S78
    <- ok
    -> M78
    <- Stats: Prints: 0, Finished: 0, Failed: 0
    <- Stats: Total time: 0s, Longest job: 0s
    <- ok
  )");
}

TEST(timer_commands, begin_with_a_wait_for_heat_and_end_where_nothing_is_heated) {
  Printer printer;
  printer.chip.heaters[0].celsius = 200;
  printer.run(1);
  printer.talk("-> M104 S200\n<- ok");
  printer.run(20);
  printer.talk("-> M31\n<- echo:Print time: 0s\n<- ok");
  printer.send("M109 S200");
  while (printer.reply() != "ok") {
  }
  printer.run(10);
  printer.talk("-> M78\n<- Stats: Prints: 1, Finished: 0, Failed: 0\n<* Total time: 0s\n<- ok");
  printer.talk("-> M104 S0\n<- ok\n-> M78\n<- Stats: Prints: 1, Finished: 1, Failed: 0");
  const auto times = printer.reply();
  ASSERT_TRUE(times.has_value());
  EXPECT_FALSE(times->contains("Longest job: 0s")) << *times;
}

}  // namespace
}  // namespace application_test
