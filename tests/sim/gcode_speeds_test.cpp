// SPDX-License-Identifier: Apache-2.0
// How fast a line may be, by F, M220 and M205, and what sets input shaping and linear advance.
#include <gtest/gtest.h>

#include "sim/report/gcode_path.hpp"

namespace {

using report::GcodePath;
using report::ShaperKind;

double speed_of(GcodePath& path, const char* command) {
  return std::get<report::Move>(path.read(command)).speed_mm_s;
}

TEST(GcodeSpeeds, hold_until_the_next_f) {
  GcodePath path;
  EXPECT_EQ(speed_of(path, "G1 X1"), 0);
  EXPECT_EQ(speed_of(path, "G1 X2 F600"), 10);
  EXPECT_EQ(speed_of(path, "G0 Y2"), 10);
  path.read("G20");
  EXPECT_DOUBLE_EQ(speed_of(path, "G1 X3 F60"), 25.4);
}

TEST(GcodeSpeeds, are_changed_by_m220_as_its_letters_say) {
  GcodePath path;
  EXPECT_EQ(speed_of(path, "G1 X2 F600"), 10);
  path.read("M220 S150");
  EXPECT_EQ(speed_of(path, "G1 X3"), 15);
  path.read("M220 B S50");
  EXPECT_EQ(speed_of(path, "G1 X4"), 5);
  path.read("M220 R");
  EXPECT_EQ(speed_of(path, "G1 X5"), 15);
}

TEST(GcodeSpeeds, are_at_least_those_of_m205) {
  GcodePath path;
  path.read("M205 S20 T40");
  EXPECT_EQ(speed_of(path, "G1 X2 F600"), 40);
  path.read("M205 T0");
  EXPECT_EQ(speed_of(path, "G1 X3"), 20);
  EXPECT_EQ(speed_of(path, "G1 X4 F6000"), 100);
  path.read("M205 S0");
  EXPECT_EQ(speed_of(path, "G1 X5 F600"), 10);
}

TEST(GcodeSpeeds, hold_back_e_as_m203_m207_and_m208_say) {
  const auto of_e = [](GcodePath& path, const char* command) {
    return std::get<report::Move>(path.read(command)).extruder_mm_s;
  };
  report::MachineFacts facts;
  facts.extruder_mm_s = 50;
  GcodePath path(facts);
  EXPECT_EQ(of_e(path, "G1 E1 F6000"), 50);
  EXPECT_EQ(of_e(path, "G10"), 50);
  path.read("M203 X1 E20");
  path.read("M207 F600");
  path.read("M208 F2400");
  EXPECT_EQ(of_e(path, "G11"), 20);
  EXPECT_EQ(of_e(path, "G10"), 10);
  EXPECT_EQ(of_e(path, "G1 X1 E3"), 20);
  EXPECT_EQ(speed_of(path, "G1 X2"), 100);
  path.read("M502");
  EXPECT_EQ(of_e(path, "G11"), 50);
}

class Shaping : public testing::Test {
 protected:
  static report::MachineFacts facts() {
    report::MachineFacts all;
    all.shaping.emplace().advance_us = 20'000;
    return all;
  }
  const report::ShaperSetting& x() const { return path.shaping().shapers[0]; }
  const report::ShaperSetting& y() const { return path.shaping().shapers[1]; }
  GcodePath path{facts()};
};

TEST_F(Shaping, is_set_for_both_axes_or_those_that_are_named) {
  path.read("M593 F40 D0.15 P\"MZV\"");
  EXPECT_EQ(x(), (report::ShaperSetting{ShaperKind::mzv, 40'000, 1500}));
  EXPECT_EQ(y(), x());
  path.read("M593 Y F35.5 S0.05");
  EXPECT_EQ(y(), (report::ShaperSetting{ShaperKind::mzv, 35'500, 500}));
  EXPECT_EQ(x().millihertz, 40'000);
  path.read("M593 X F0");
  EXPECT_EQ(x().kind, ShaperKind::none);
  path.read("M593 X F50");
  EXPECT_EQ(x().kind, ShaperKind::zv);
}

TEST_F(Shaping, has_the_advance_of_m900_or_m572_and_the_machine_s_after_m502) {
  EXPECT_EQ(path.shaping().advance_us, 20'000);
  path.read("M900 K0.05");
  EXPECT_EQ(path.shaping().advance_us, 50'000);
  path.read("M572 S0.07");
  EXPECT_EQ(path.shaping().advance_us, 70'000);
  path.read("M593 F40");
  path.read("M502");
  EXPECT_EQ(path.shaping(), *facts().shaping);
}

TEST(NoShaping, is_not_set_on_a_machine_without_it) {
  GcodePath path;
  path.read("M593 F40");
  path.read("M900 K0.05");
  EXPECT_FALSE(path.shaping().any());
}

}  // namespace
