// SPDX-License-Identifier: Apache-2.0
// M420 M421 M851: the use of the mesh, its points, and the probe's offset.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/application/probed_printer.hpp"

namespace application_test {
namespace {

using testing::HasSubstr;

class LevellingCommands : public ProbedPrinter {};

TEST_F(LevellingCommands, switch_and_report_the_use_of_the_mesh) {
  printer.talk(R"(
    -> M420
    <- echo:Bed Leveling OFF
    <- echo:Fade Height 10.00
    <- ok
    -> M420 S1
    <- Error:Failed to enable Bed Leveling: no mesh, G29 first
    <- ok
    -> M421 Z0.2
    <- ok
    -> M420 S1 Z0
    <- echo:Bed Leveling ON
    <- echo:Fade Height OFF
    <- ok
    -> M420 Z-1
    <* Z not within 0 to 1000
    <- ok
    -> M420 C1
    <* M420 takes S Z V T
    <- ok
    -> M420 Z0.3
    <- Error:Failed to enable Bed Leveling: M420 Z below twice the highest of the mesh
    <- ok
    -> M420
    <- echo:Bed Leveling ON
    <- echo:Fade Height OFF
    <- ok
    -> M420 S0 Z2.5
    <- echo:Bed Leveling OFF
    <- echo:Fade Height 2.50
    <- ok
    -> M420 S1
    <- echo:Bed Leveling ON
    <- echo:Fade Height 2.50
    <- ok
    -> G28
    <- ok
    -> M420
    <- echo:Bed Leveling OFF
    <- echo:Fade Height 2.50
    <- ok
  )");
}

TEST_F(LevellingCommands, show_and_change_points_of_the_mesh) {
  printer.talk(R"(
    -> M420 V
    <- echo:Bed Leveling OFF
    <- echo:Fade Height 10.00
    <- ok
    -> M421 I0 J0 Q0.1
    <* Q needs a mesh, G29 first
    <- ok
    -> M421 Z0.1
    <- ok
    -> M421 I4 J3 Z-1.2344
    <- ok
    -> M421 I0 J0 Q0.05
    <- ok
    -> M421 I2 Q-0.1
    <- ok
    -> M421 I5 J0 Z0
    <* Mesh point cannot be resolved
    <- ok
    -> M421 I1 J4 Z0
    <* Mesh point cannot be resolved
    <- ok
    -> M421 I1 J1
    <* M421 incorrect parameter usage
    <- ok
    -> M421 I1 J1 Z0 Q0
    <* M421 incorrect parameter usage
    <- ok
    -> M421 I1 J1 Z10.1
    <* Height not within -10 to 10
    <- ok
    -> M420 V1
    <- Bilinear Leveling Grid:
    <-       0      1      2      3      4
    <-  0 +0.150 +0.100 +0.000 +0.100 +0.100
    <-  1 +0.100 +0.100 +0.000 +0.100 +0.100
    <-  2 +0.100 +0.100 +0.000 +0.100 +0.100
    <-  3 +0.100 +0.100 +0.000 +0.100 -1.234
    <- echo:Bed Leveling OFF
    <- echo:Fade Height 10.00
    <- ok
  )");
}

TEST_F(LevellingCommands, set_and_report_the_offset_of_the_probe) {
  printer.talk(R"(
    -> M851
    <- echo: M851 X20.00 Y-10.00 Z-1.50
    <- ok
    -> M851 X25 Z-1.4
    <- ok
    -> M851 Z20.1
    <* Z not within -20 to 20
    <- ok
    -> M851 X101 Z0
    <* X or Y not within -100 to 100
    <- ok
    -> M851
    <- echo: M851 X25.00 Y-10.00 Z-1.40
    <- ok
    -> G28
    <- ok
  )");
  // A probe that is believed to trigger lower finds the bed higher.
  EXPECT_EQ(answer("G30 X80 Y60"),
            fmt::format("Bed X: 80.00 Y: 60.00 Z: {:.2f}\n", uneven(75, 60) + 0.1));
}

// The nozzle ends at the height of its travels, and a line goes where it says from there.
TEST_F(LevellingCommands, know_where_the_nozzle_is_after_g30) {
  printer.talk("-> G28\n<- ok");
  answer("G30 X80 Y60");
  const auto height = [&] {
    return static_cast<double>(printer.chip.mechanical[z]) / printer.chip.steps_per_mm[z];
  };
  EXPECT_GT(height(), 1);
  EXPECT_THAT(answer("M114"), HasSubstr(fmt::format("Z:{:.2f} ", height())));
  printer.talk("-> G1 Z1.5\n<- ok\n-> M400\n<- ok");
  EXPECT_NEAR(height(), 1.5, 0.5 / printer.chip.steps_per_mm[z]);
}

TEST_F(LevellingCommands, are_listed_and_restored_with_the_settings) {
  printer.talk("-> M421 Z0.1\n<- ok\n-> M851 Z-2\n<- ok");
  EXPECT_THAT(answer("M420 S1 Z5"), HasSubstr("ON"));
  EXPECT_THAT(answer("M503"), HasSubstr("echo: M420 S1 Z5.00\necho: M851 X20.00 Y-10.00 Z-2.00\n"));
  printer.talk("-> M502\n<- echo:Hardcoded Default Settings Loaded\n<- ok");
  EXPECT_THAT(answer("M503"),
              HasSubstr("echo: M420 S0 Z10.00\necho: M851 X20.00 Y-10.00 Z-1.50\n"));
  EXPECT_THAT(answer("M420 S1"), HasSubstr("no mesh"));
}

// The nozzle stays, and the host's Z says where it is.
TEST_F(LevellingCommands, leave_the_nozzle_where_m502_finds_it) {
  home();
  printer.talk("-> M421 Z-0.3\n<- ok");
  EXPECT_THAT(answer("M420 S1 Z0"), HasSubstr("ON"));
  printer.talk("-> G1 Z1 F600\n<- ok\n-> M400\n<- ok");
  EXPECT_NEAR(printer.mm(z), 0.7, 0.001);
  printer.talk("-> M502\n<- echo:Hardcoded Default Settings Loaded\n<- ok");
  EXPECT_THAT(answer("M114"), HasSubstr("Z:0.70 "));
  EXPECT_NEAR(printer.mm(z), 0.7, 0.001);
}

TEST_F(LevellingCommands, are_as_they_were_where_m421_or_m851_is_refused) {
  printer.talk("-> M421 Z0.1\n<- ok");
  EXPECT_THAT(answer("M420 S1 Z1"), HasSubstr("ON"));
  const std::string before = answer("M420 V");
  EXPECT_THAT(answer("M421 I0 J0 Z0.9"), HasSubstr("half of the fade height"));
  EXPECT_EQ(answer("M420 V"), before);
  EXPECT_THAT(answer("M851 Z-20"), HasSubstr("above the probe's clearance"));
  EXPECT_THAT(answer("M851"), HasSubstr("Z-1.50"));
}

TEST_F(LevellingCommands, are_among_the_capabilities_and_the_switches) {
  EXPECT_THAT(answer("M115"), HasSubstr("Cap:AUTOLEVEL:1\nCap:LEVELING_DATA:1\nCap:Z_PROBE:1\n"));
  EXPECT_THAT(answer("M119"), HasSubstr("z_probe: open\n"));
  lay([](double, double) { return 1000.0; });
  printer.run(0.1);
  EXPECT_THAT(answer("M119"), HasSubstr("z_probe: TRIGGERED\n"));
}

}  // namespace
}  // namespace application_test
