// SPDX-License-Identifier: Apache-2.0
// What is out of reach of a delta and a SCARA is refused before anything moves.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>

#include "tests/application/described_machine.hpp"

namespace application_test {
namespace {

using testing::HasSubstr;
using units::Nanometers;

// Five by five points from -first to first, or to the last.
motion::LevellingSettings grid(double first_x, double last_x, double first_y, double last_y) {
  const auto length = [](double mm) { return Nanometers(static_cast<std::int64_t>(mm * 1e6)); };
  motion::LevellingSettings settings;
  settings.probe = {.input = FakeChip::probe_input,
                    .offset = {},
                    .fast_speed = units::MicrometersPerSecond(8'000),
                    .slow_speed = units::MicrometersPerSecond(1'000),
                    .travel_speed = units::MicrometersPerSecond(100'000),
                    .clearance = Nanometers(5'000'000),
                    .back_off = Nanometers(1'000'000),
                    .deepest = Nanometers(-1'000'000)};
  settings.mesh.axes[0] = {length(first_x), length(last_x), 5};
  settings.mesh.axes[1] = {length(first_y), length(last_y), 5};
  return settings;
}

class OtherKinematics : public testing::Test {
 protected:
  OtherKinematics(const std::string& name, const motion::LevellingSettings& levelling)
      : printer([&] {
          application::MachineDescription machine = described_machine(name);
          machine.levelling = &levelling;
          return machine;
        }()) {
    hang_below_end_stops(printer.chip);
    execute({"G28"});
  }
  void execute(std::initializer_list<std::string> lines) {
    for (const std::string& line : lines) printer.talk("-> " + line + "\n<- ok\n");
    printer.talk("-> M400\n<- ok\n");
  }
  // Refused, and nothing moves after it.
  void expect_refused(const std::string& line, const std::string& reason) {
    const auto before = printer.chip.mechanical;
    printer.send(line);
    EXPECT_THAT(printer.reply().value_or("nothing"), HasSubstr(reason));
    EXPECT_EQ(printer.reply(), "ok");
    execute({});
    EXPECT_EQ(printer.chip.mechanical, before) << line;
  }

  Printer printer;
};

const motion::LevellingSettings delta_grid = grid(-60, 60, -60, 60);
class LevelledDelta : public OtherKinematics {
 protected:
  LevelledDelta() : OtherKinematics("delta", delta_grid) {
    for (const int column : {0, 1, 2}) execute({fmt::format("M421 I{} Z0", column)});
    execute({"M421 I3 Z2", "M421 I4 Z2"});
    printer.talk("-> M420 S1 Z0\n<- echo:Bed Leveling ON\n<- echo:Fade Height OFF\n<- ok");
  }
};

// Above X20 the mesh adds 1.33 mm, and the cone of reach ends at Z240.74.
TEST_F(LevelledDelta, refuses_a_line_that_the_mesh_leads_out_of_reach_before_it_moves) {
  execute({"G1 X-20 Y0 Z240.5 F6000"});
  expect_refused("G1 X20", "out of reach above the mesh");
  execute({"G1 X20 Z239.2"});
  printer.talk("-> M114\n<* X:20.00 Y:0.00 Z:239.20\n<- ok");
}

TEST_F(LevelledDelta, goes_wherever_it_is_within_reach) {
  execute({"G1 Z249.9 F6000", "G1 X-20 Z240.5", "G1 X0", "G1 Z249.9"});
  printer.talk("-> M114\n<* X:0.00 Y:0.00 Z:249.90\n<- ok");
}

class Delta : public OtherKinematics {
 protected:
  Delta() : OtherKinematics("delta", delta_grid) {}
};

// Its ends are within reach, its middle is not: the arc ends before it, and the host is where the
// nozzle is.
TEST_F(Delta, keeps_the_hosts_place_where_an_arc_leaves_its_reach) {
  execute({"G1 X60 Y-50 Z50 F6000"});
  printer.send("G3 X60 Y50 R50");
  EXPECT_THAT(printer.reply().value_or("nothing"), HasSubstr("out of reach"));
  EXPECT_EQ(printer.reply(), "ok");
  execute({"G1 X0 Y0"});
  printer.talk("-> M114\n<* X:0.00 Y:0.00 Z:50.00\n<- ok");
  EXPECT_NEAR(printer.chip.position[0], printer.chip.position[1], 1);
  EXPECT_NEAR(printer.chip.position[0], printer.chip.position[2], 1);
}

TEST_F(Delta, reports_its_geometry_and_the_offsets_of_its_end_stops) {
  printer.talk(R"(
    -> M665
    <- echo: M665 L250.000 R105.000 H250.000 X0.000 Y0.000 Z0.000 A0.000 B0.000 C0.000
    <- ok
    -> M666
    <- echo: M666 X0.000 Y0.000 Z0.000
    <- ok
    -> M665 L251.5 R106.25 H249 X0.5 Y-0.25 Z1 A0.1 B-0.2 C0.3
    <- ok
    -> M666 X-0.5 Z-0.025
    <- ok
    -> M503
    <* M92
    <* M203
    <* M201
    <* M204
    <* M205
    <* M207
    <* M208
    <* M209
    <* M420
    <* M851
    <- echo: M665 L251.500 R106.250 H249.000 X0.500 Y-0.250 Z1.000 A0.100 B-0.200 C0.300
    <- echo: M666 X-0.500 Y0.000 Z-0.025
    <- ok
    -> M502
    <* Hardcoded
    <- ok
    -> M665
    <- echo: M665 L250.000 R105.000 H250.000 X0.000 Y0.000 Z0.000 A0.000 B0.000 C0.000
    <- ok
    -> M666
    <- echo: M666 X0.000 Y0.000 Z0.000
    <- ok
  )");
}

TEST_F(Delta, refuses_a_geometry_that_cannot_be_and_stays_homed) {
  expect_refused("M665 L199", "rods would lie flat");
  expect_refused("M665 L340", "upright");
  expect_refused("M665 H0", "H not within");
  expect_refused("M665 R100 X10.1", "X, Y or Z not within");
  expect_refused("M665 C-11", "A, B or C not within");
  expect_refused("M666 Y0.1", "M666 offsets must be <= 0");
  execute({"M665 S100", "M665 L250", "G1 X10 Y10 Z100 F6000"});
  printer.talk("-> M114\n<* X:10.00 Y:10.00 Z:100.00\n<- ok");
}

// The carriages by the geometry alone, X and Y along the towers' axes of symmetry.
TEST_F(Delta, goes_by_its_new_geometry_once_it_is_homed) {
  execute({"G1 X10 Z100 F6000", "M665 L255 R110 H240 A1 Z2"});
  expect_refused("G1 X0", "home first");
  execute({"G28"});
  printer.talk("-> M114\n<* X:0.00 Y:0.00 Z:240.00\n<- ok");
  execute({"G1 X30 Y-20 Z50 F6000"});
  const std::array<double, 3> rods{256, 255, 255}, degrees{210, 330, 92};
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = degrees[i] * std::numbers::pi / 180;
    const double x = 30 - 110 * std::cos(angle), y = -20 - 110 * std::sin(angle);
    const double height = 50 + std::sqrt(rods[i] * rods[i] - x * x - y * y);
    EXPECT_NEAR(static_cast<double>(printer.chip.position[i]), height * 80, 0.51) << i;
  }
  expect_refused("G1 X0 Y0 Z240.1", "beyond the end of Z (0.00 to 240.00)");
  printer.talk("-> M211\n<* Z240.00\n<- ok");
}

TEST_F(Delta, hangs_its_carriages_by_m666_below_their_end_stops) {
  const auto home = printer.chip.mechanical;
  execute({"M666 Y-0.5 Z-1", "G1 Z200 F6000", "G28"});
  const std::array<std::int64_t, 3> lower{0, 40, 80};  // steps
  for (std::size_t i = 0; i < lower.size(); ++i) {
    EXPECT_LE(std::abs(home[i] - lower[i] - printer.chip.mechanical[i]), 1) << i;
  }
  printer.talk("-> M114\n<* X:0.00 Y:0.00 Z:250.00\n<- ok");
}

TEST_F(Delta, is_homed_again_after_m502_only_where_that_changes_its_geometry) {
  execute({"G1 Z100 F6000"});
  printer.talk("-> M502\n<* Hardcoded\n<- ok");
  execute({"G1 Z90", "M665 A0.5", "G28"});
  printer.talk("-> M502\n<* Hardcoded\n<- ok");
  expect_refused("G1 Z90", "home first");
}

// The shoulder is at X100 Y-120, and the nozzle keeps 130 mm from it: not at X100 Y5.
const motion::LevellingSettings scara_grid = grid(20, 180, 5, 105);
class LevelledScara : public OtherKinematics {
 protected:
  LevelledScara() : OtherKinematics("scara", scara_grid) {}
};

TEST_F(LevelledScara, names_an_inner_point_of_the_grid_that_it_does_not_reach_before_it_moves) {
  expect_refused("G29", "does not reach X100.00 Y5.00");
  expect_refused("G29 L50 R150 X3", "does not reach X100.00 Y5.00");
  execute({"M206 X-10"});
  expect_refused("G29 L40 R140 X3", "does not reach X90.00 Y5.00");
}

// Both points are within reach, the way from one to the other is not.
TEST_F(LevelledScara, names_a_point_to_which_it_has_no_way_before_it_moves) {
  expect_refused("G29 L40 R160 F5 X2", "does not reach X160.00 Y5.00");
  execute({"G1 X40 Y5 F6000"});
  expect_refused("G30 X160 Y5", "The probe does not reach X and Y");
}

}  // namespace
}  // namespace application_test
