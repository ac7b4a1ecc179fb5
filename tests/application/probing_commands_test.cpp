// SPDX-License-Identifier: Apache-2.0
// G29 and G30: what they say, where the probe goes, and what ends them.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "tests/application/probed_printer.hpp"

namespace application_test {
namespace {

using testing::HasSubstr;

class ProbingCommands : public ProbedPrinter {
 protected:
  // What G29 prints, where each height is that of the bed.
  std::string grid(double first_x, double last_x, int columns, double first_y, double last_y,
                   int rows, const std::function<double(double, double)>& bed) {
    std::string text = "Bilinear Leveling Grid:\n";
    for (int i = 0; i < columns; ++i) text += fmt::format("{}{}", "      ", i);
    for (int j = 0; j < rows; ++j) {
      text += fmt::format("\n {}", j);
      for (int i = 0; i < columns; ++i) {
        text += fmt::format(" {:+.3f}", bed(first_x + (last_x - first_x) * i / (columns - 1),
                                            first_y + (last_y - first_y) * j / (rows - 1)));
      }
    }
    return text + "\n";
  }
  // Probing rounds to steps of Z: a micrometre up or down.
  static void expect_same_heights(const std::string& said, const std::string& expected) {
    std::istringstream words(said), others(expected);
    std::string word, other;
    while (words >> word && others >> other) {
      if (other.find('.') == std::string::npos) {
        EXPECT_EQ(word, other) << said;
      } else {
        EXPECT_NEAR(std::stod(word), std::stod(other), 0.0011) << said << expected;
        EXPECT_EQ(word.size(), other.size()) << word;
      }
    }
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'),
              std::count(expected.begin(), expected.end(), '\n'));
  }
  void expect_probing_to_halt(const std::string& line, const std::string& reason) {
    printer.send(line);
    std::string all;
    while (const auto said = printer.reply(60)) {
      all += *said + "\n";
      if (said->find("kill()") != std::string::npos) break;
    }
    EXPECT_THAT(all, HasSubstr("Error:Probing Failed at X"));
    EXPECT_THAT(all, HasSubstr(reason));
    EXPECT_THAT(all, HasSubstr("Printer halted"));
    EXPECT_EQ(printer.chip.motors, 0u);
    const auto stopped_at = printer.chip.mechanical;
    printer.send("G1 Z0 F600");
    printer.run(3);
    EXPECT_EQ(printer.chip.mechanical, stopped_at);
  }
};

TEST_F(ProbingCommands, probe_the_bed_in_a_grid) {
  home();
  expect_same_heights(answer("G29"), grid(30, 190, 5, 10, 180, 4, uneven));
  EXPECT_EQ(answer("M420"), "echo:Bed Leveling ON\necho:Fade Height 10.00\n");
  EXPECT_NEAR(printer.mm(z), 5, 0.4);  // at the clearance, by the host's coordinates
}

TEST_F(ProbingCommands, probe_where_the_line_says_and_as_many_points) {
  home();
  expect_same_heights(answer("G29 L50 R150 F40 B100 X3 Y2"), grid(50, 150, 3, 40, 100, 2, uneven));
  // In the host's coordinates, here 10 mm less along X; the machine's are the same.
  printer.talk("-> M206 X-10\n<- ok");
  expect_same_heights(answer("G29 L40 R140 F40 B100 X3 Y2"), grid(50, 150, 3, 40, 100, 2, uneven));
  expect_same_heights(answer("G29 X15 Y15"), grid(30, 190, 15, 10, 180, 15, uneven));
}

TEST_F(ProbingCommands, count_the_points_where_they_are_asked_to) {
  home();
  const std::string said = answer("G29 X2 Y2 V1 S3000");
  for (int i = 1; i <= 4; ++i) {
    EXPECT_THAT(said, HasSubstr(fmt::format("Probing mesh point {}/4.\n", i)));
  }
}

// Up and across, and nowhere lower than the end of the descent; there and back, row by row.
TEST_F(ProbingCommands, lead_the_probe_from_point_to_point) {
  home();
  struct Contact {
    double x, y, z;
  };
  std::vector<Contact> contacts;
  double lowest = 10, lowest_across = 10;
  double before_x = printer.mm(x), before_y = printer.mm(y);
  bool touches = false;
  printer.send("G29 X3 Y3");
  for (int i = 0; i < 2'000 && printer.mm(z) < 4.99; ++i) printer.run(0.001);
  for (int i = 0; i < 300'000; ++i) {
    printer.run(0.001);
    const double at_x = printer.mm(x), at_y = printer.mm(y), at_z = printer.mm(z);
    const bool now = at_z <= printer.chip.probe_mm(at_x, at_y);
    if (now && !touches) contacts.push_back({at_x + offset_x, at_y + offset_y, at_z});
    touches = now;
    lowest = std::min(lowest, at_z - printer.chip.probe_mm(at_x, at_y));
    if (at_x != before_x || at_y != before_y) lowest_across = std::min(lowest_across, at_z);
    before_x = at_x;
    before_y = at_y;
    if (const auto said = printer.reply(0.0001); said && *said == "ok") break;
  }
  EXPECT_GT(lowest, -0.02);  // at 8 mm/s in a millisecond
  EXPECT_GT(lowest_across, 4.99);
  ASSERT_GE(contacts.size(), 9u);
  EXPECT_NEAR(contacts.front().x, 30, 0.1);
  EXPECT_NEAR(contacts.front().y, 10, 0.1);
  EXPECT_NEAR(contacts.back().x, 190, 0.1);
  EXPECT_NEAR(contacts.back().y, 180, 0.1);
  const auto middle = std::ranges::find_if(
      contacts, [](const Contact& contact) { return std::abs(contact.y - 95) < 1; });
  ASSERT_NE(middle, contacts.end());
  EXPECT_NEAR(middle->x, 190, 0.1);  // back from the right
}

TEST_F(ProbingCommands, probe_one_place) {
  home();
  EXPECT_EQ(answer("G30 X80 Y60"),
            fmt::format("Bed X: 80.00 Y: 60.00 Z: {:.2f}\n", uneven(80, 60)));
  EXPECT_NEAR(printer.mm(x), 80 - offset_x, 0.01);
  EXPECT_NEAR(printer.mm(y), 60 - offset_y, 0.01);
  EXPECT_NEAR(printer.mm(z), 5, 0.01);
  // Where the probe is, in the host's coordinates.
  printer.talk("-> G92 X0 Y100\n<- ok");
  EXPECT_EQ(answer("G30"), fmt::format("Bed X: 20.00 Y: 90.00 Z: {:.2f}\n", uneven(80, 60)));
}

TEST_F(ProbingCommands, refuse_to_probe_before_homing) {
  const auto before = printer.chip.mechanical;
  EXPECT_THAT(answer("G29"), HasSubstr("Home XYZ first"));
  EXPECT_THAT(answer("G30 X50 Y50"), HasSubstr("Home XYZ first"));
  home();
  printer.talk("-> M84\n<- ok");  // a hand may have moved them
  EXPECT_THAT(answer("G29"), HasSubstr("Home XYZ first"));
  EXPECT_EQ(printer.counters.commands_refused, 3u);
  EXPECT_EQ(before[e], printer.chip.mechanical[e]);
}

TEST_F(ProbingCommands, refuse_what_the_probe_does_not_reach_and_do_not_move) {
  home();
  const auto before = printer.chip.mechanical;
  for (const std::string line :
       {"G29 L10", "G29 R221", "G29 F-11", "G29 B191", "G30 X19 Y50", "G30 X50 Y191"}) {
    EXPECT_THAT(answer(line), HasSubstr("robe does not reach")) << line;
  }
  EXPECT_THAT(answer("G29 L100 R100.5"), HasSubstr("R must be right of L"));
  EXPECT_THAT(answer("G29 F100 B50"), HasSubstr("B behind F"));
  EXPECT_THAT(answer("G29 X1"), HasSubstr("not within 2 to 15 points"));
  EXPECT_THAT(answer("G29 Y16"), HasSubstr("not within 2 to 15 points"));
  EXPECT_THAT(answer("G29 J"), HasSubstr("G29 takes L R F B X Y S V"));
  EXPECT_THAT(answer("G29 S0"), HasSubstr("S must be above 0"));
  EXPECT_EQ(printer.chip.mechanical, before);
}

TEST_F(ProbingCommands, halt_where_the_probe_does_not_trigger) {
  home();
  printer.chip.probe_mm = nullptr;
  expect_probing_to_halt("G29", "not triggered down to the deepest place");
  EXPECT_NEAR(printer.mm(z), deepest - offset_z, 0.01);  // above the bed by half a millimetre
}

TEST_F(ProbingCommands, halt_where_the_bed_ends) {
  home();
  lay([](double at_x, double) { return at_x > 100 ? -50.0 : 0.1; });
  expect_probing_to_halt("G29", "Probing Failed at X110.00 Y10.00: not triggered");
  EXPECT_GT(printer.mm(z), deepest - offset_z - 0.01);
}

TEST_F(ProbingCommands, halt_where_the_probe_is_triggered_already) {
  home();
  lay([](double, double) { return 1000.0; });
  const double at_x = printer.mm(x), at_y = printer.mm(y);
  expect_probing_to_halt("G30 X80 Y60", "triggered before its descent");
  EXPECT_EQ(printer.mm(x), at_x);
  EXPECT_EQ(printer.mm(y), at_y);
  EXPECT_NEAR(printer.mm(z), 5, 0.01);
}

TEST_F(ProbingCommands, halt_where_something_is_in_the_probe_s_way) {
  home();
  lay([](double at_x, double) { return at_x > 60 ? 20.0 : 0.0; });
  expect_probing_to_halt("G30 X150 Y60", "triggered before its descent");
  EXPECT_NEAR(printer.mm(x) + offset_x, 60, 0.1);
}

TEST_F(ProbingCommands, halt_where_the_probe_does_not_open_again) {
  home();
  bool stuck = false;
  printer.chip.probe_mm = [&stuck](double, double) { return stuck ? 1000.0 : 1.5; };
  printer.send("G30 X80 Y60");
  for (int i = 0; i < 2'000 && printer.mm(z) < 4.99; ++i) printer.run(0.001);
  for (int i = 0; i < 10'000 && printer.mm(z) > 1.5; ++i) printer.run(0.001);
  stuck = true;
  expect_probing_to_halt("M105", "still triggered after its back-off");
  EXPECT_LT(printer.mm(z), 2.6);
}

TEST_F(ProbingCommands, halt_where_the_bed_is_too_high_to_be_true) {
  home();
  printer.talk("-> M851 Z20\n<- ok");  // the wrong sign
  lay([](double, double) { return 1.0; });
  expect_probing_to_halt("G29", "check M851 Z");
}

TEST_F(ProbingCommands, end_with_a_quick_stop) {
  home();
  printer.send("G29");
  printer.run(1.5);
  printer.send("M410");
  std::string all;
  while (const auto said = printer.reply(1)) all += *said + "\n";
  EXPECT_THAT(all, HasSubstr("Probing was stopped"));
  const auto stopped_at = printer.chip.mechanical;
  printer.run(5);
  EXPECT_EQ(printer.chip.mechanical, stopped_at);
  EXPECT_THAT(answer("M420 S1"), HasSubstr("no mesh, G29 first"));
}

// On the way, in the descents, and while the nozzle rises with a result.
TEST_F(ProbingCommands, end_with_a_quick_stop_at_any_moment) {
  for (double seconds = 0.3; seconds < 5; seconds += 0.06) {
    home();
    printer.send("G29 V1");
    printer.run(seconds);
    printer.send("M410");
    std::string all;
    while (const auto said = printer.reply(1)) all += *said + "\n";
    EXPECT_THAT(all, HasSubstr("Probing was stopped")) << seconds;
    const auto stopped_at = printer.chip.mechanical;
    printer.run(2);
    EXPECT_EQ(printer.chip.mechanical, stopped_at) << seconds;
  }
}

}  // namespace
}  // namespace application_test
