// SPDX-License-Identifier: Apache-2.0
// When the sensor of filament is not looked at, and M701 whose nozzle gets cold.
#include "tests/application/filament_printer.hpp"

namespace application_test {
namespace {

// What M600 would ask is none of the host's there, and it is not asked again and again.
TEST_F(Filament, is_not_looked_at_where_lines_are_not_executed) {
  for (const auto& [begin, end] :
       {std::pair{"M28 part.gco", "M29"}, std::pair{"M111 S8", "M111 S0"},
        std::pair{"M37 S1", "M37 S0"}}) {
    talk(std::string("-> M75\n<- ok\n-> ") + begin + "\n<* No\n<- ok");
    printer.chip.filament_is_out = true;
    expect_silence(2);
    printer.send(end);
    while (printer.reply().value_or("ok") != "ok") {
    }
    talk("<- echo:Filament has run out\n<- //action:paused\n<* begin\n<* button\n<* show");
    printer.chip.filament_is_out = false;
    talk("-> M108\n<- //action:prompt_end\n<- //action:resumed\n<- ok");
  }
}

// It is not looked for while M701 or M702 moves it, nor before it has been seen again.
TEST_F(Filament, may_be_away_from_m702_until_it_is_back) {
  talk("-> M75\n<- ok");
  printer.send("M702");
  printer.run(1);
  printer.chip.filament_is_out = true;
  talk("<- ok");
  expect_silence(3);
  printer.send("M701");
  printer.run(1.5);
  printer.chip.filament_is_out = false;
  talk("<- ok");
  expect_silence();
  printer.chip.filament_is_out = true;
  talk("<- echo:Filament has run out\n<- //action:paused");
}

TEST_F(Filament, that_is_back_by_hand_after_m702_is_looked_at) {
  talk("-> M75\n<- ok\n-> M702\n<- ok");
  printer.chip.filament_is_out = true;
  printer.run(1);
  printer.chip.filament_is_out = false;
  printer.run(1);
  printer.chip.filament_is_out = true;
  talk("<- echo:Filament has run out\n<- //action:paused");
}

TEST_F(Filament, that_m702_has_taken_before_a_print_is_asked_for_in_it) {
  talk("-> M702\n<- ok");
  printer.chip.filament_is_out = true;
  talk("-> M75\n<- ok\n<- echo:Filament has run out\n<- //action:paused");
}

// Seen while the line that stops the timer is held back.
TEST_F(Filament, is_not_asked_for_once_the_timer_has_stopped) {
  for (const char* stop : {"M76", "M77"}) {
    talk("-> M75\n<- ok");
    printer.send("//action:pause");
    printer.send(stop);
    printer.run(0.2);
    printer.chip.filament_is_out = true;
    printer.run(0.5);
    printer.send("//action:resume");
    std::string said;
    while (const auto line = printer.reply(1)) said += *line + "\n";
    EXPECT_THAT(said, testing::Not(testing::HasSubstr("run out"))) << stop;
    printer.chip.filament_is_out = false;
  }
}

// 50 mm are made, then the nozzle is colder than M302 says.
TEST_F(Filament, is_left_where_it_is_and_z_lowered_where_the_nozzle_gets_cold) {
  printer.send("M701 Z5");
  printer.run(2);
  EXPECT_EQ(printer.chip.position[2], 15 * 2560);
  printer.chip.heaters[0].celsius = 20;
  talk("<- echo:Hotend too cold, not executed: \"M701 Z5\"\n<- ok");
  EXPECT_EQ(printer.chip.position[2], 10 * 2560);
  EXPECT_DOUBLE_EQ(filament(), 50);
}

}  // namespace
}  // namespace application_test
