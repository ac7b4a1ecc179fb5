// SPDX-License-Identifier: Apache-2.0
// G27, G60, G61 and M290, by where the axes go.
#include "tests/application/homed_printer.hpp"

namespace application_test {
namespace {

class Places : public HomedPrinter {
 protected:
  Places() { execute({"G1 X10 Y20 Z5 F6000"}); }
  double travel(std::size_t axis) const {
    return static_cast<double>(machine_under_test().limits.axes[axis].travel.count()) / 1e6;
  }
};

TEST_F(Places, of_parking_are_10_mm_from_the_left_and_from_the_back) {
  execute({"G27"});
  expect(10, travel(y) - 10, 20);
  execute({"G1 X12 Y30"});  // the host's coordinates have followed
  expect(12, 30, 20);
}

TEST_F(Places, of_parking_are_no_lower_than_the_head) {
  execute({"G1 Z30", "G27"});
  expect(10, travel(y) - 10, 30);
  execute({"G27 P1"});
  expect(10, travel(y) - 10, 20);
  execute({"G27 P2"});
  expect(10, travel(y) - 10, 40);
  execute({"G1 Z100 F200", "G27 P2"});
  expect(10, travel(y) - 10, travel(z));
}

TEST(places, of_parking_need_homing) {
  Printer printer;
  printer.talk("-> G28 X\n<- ok\n-> G27\n<* Home XYZ first\n<- ok\n");
}

TEST_F(Places, that_are_saved_are_found_again) {
  execute({"G1 E2", "G60", "G1 X50 Y60 Z7 E1", "G60 S1", "G1 X70 Y70", "G61"});
  expect(10, 20, 5);
  EXPECT_NEAR(printer.mm(e), 1, step);  // E does not move,
  execute({"G1 E3"});  // but its coordinate is that of the place
  EXPECT_NEAR(printer.mm(e), 2, step);
  execute({"G61 S1 X Y5 F3000"});
  expect(50, 65, 5);
}

TEST_F(Places, that_are_saved_are_the_machines) {
  execute({"G60", "G92 X0 Y0", "G1 X40", "G61 X"});
  expect(10, 20, 5);
  execute({"G1 X1"});
  expect(11, 20, 5);
}

// The lift of G10 and baby steps are not part of them: G11 lowers by what G10 has lifted.
TEST_F(Places, that_are_saved_know_nothing_of_lifts) {
  execute({"M207 Z1", "G60", "G10", "G27", "G61", "G11"});
  expect(10, 20, 5);
  execute({"G10", "G60", "G11", "G1 X50", "G61"});
  expect(10, 20, 5);
  execute({"M290 Z0.1", "G1 X50", "G61"});
  expect(10, 20, 5.1);
}

TEST_F(Places, that_are_refused_leave_the_feedrate) {
  execute({"G60", "G1 X20 F1200"});
  printer.talk("-> G61 Z-50 F60\n<* Move beyond the end of Z\n<- ok\n");
  const auto before = printer.chip.time;
  execute({"G1 X40"});
  EXPECT_LT(static_cast<double>(printer.chip.time - before) / clock_hz, 5);  // 1 s at F1200
}

TEST_F(Places, that_are_not_saved_are_refused) {
  printer.talk("-> G61\n<* No position saved in this slot\n<- ok\n");
  printer.talk("-> G60 S2\n<* S not within 0 to 1\n<- ok\n");
  execute({"G60 S1"});
  printer.talk("-> G61 S0\n<* No position saved in this slot\n<- ok\n");
}

TEST_F(Places, of_baby_steps_are_made_at_rest) {
  execute({"M290 Z0.1"});
  expect(10, 20, 5.1);
  execute({"M290 S-0.04", "G1 X11 Z6"});  // Z6 is still 0.06 above that
  expect(11, 20, 6.06);
  printer.talk("-> M290\n<- echo:Babystep Z:0.060\n<- ok\n");
  execute({"M290 Z9"});
  expect(11, 20, 8.06);
  execute({"G28 Z"});  // ends all of them
  printer.talk("-> M290\n<- echo:Babystep Z:0.000\n<- ok\n");
}

TEST_F(Places, of_baby_steps_are_made_with_the_next_line_in_motion) {
  for (const char* line : {"G1 X60", "M290 Z0.2", "G1 E1", "G1 X70", "G1 X80 Z5"}) {
    printer.talk("-> " + std::string(line) + "\n<- ok\n");
  }
  execute({});
  expect(80, 20, 5.2);
}

TEST_F(Places, of_baby_steps_bend_no_arc) {
  for (const char* line : {"G1 X60", "M290 Z0.05", "G18", "G2 X65 Z10 I5 K0", "G1 X70"}) {
    printer.talk("-> " + std::string(line) + "\n<- ok\n");
  }
  execute({});
  expect(70, 20, 10.05);
}

TEST_F(Places, of_baby_steps_lie_within_the_travel) {
  execute({"G1 Z0"});
  printer.talk("-> M290 Z-0.1\n<* Move beyond the end of Z\n<- ok\n");
  expect(10, 20, 0);
}

}  // namespace
}  // namespace application_test
