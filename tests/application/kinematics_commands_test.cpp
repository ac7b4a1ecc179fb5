// SPDX-License-Identifier: Apache-2.0
// What is out of reach of a delta and a SCARA is refused before anything moves.
#include <fmt/format.h>
#include <gmock/gmock.h>

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
