// SPDX-License-Identifier: Apache-2.0
// M425: axes that have play go where they are led to, and positions do not show it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

using units::Nanometers;

constexpr std::size_t x = 0, y = 1, z = 2;
constexpr std::array<double, 3> steps_per_mm{80, 80, 2560};
constexpr std::array<double, 3> play_mm{0.2, 0.15, 0.05};

const motion::BacklashSettings settings{
    .lengths = {Nanometers(200'000), Nanometers(150'000), Nanometers(50'000)}};

application::MachineDescription machine_with_play(const motion::BacklashSettings& fitted) {
  application::MachineDescription machine = machine_under_test();
  machine.backlash = &fitted;
  return machine;
}

class Backlash : public testing::Test {
 protected:
  explicit Backlash(const motion::BacklashSettings& fitted = settings)
      : printer(machine_with_play(fitted)) {
    talk("-> G28\n<- ok\n-> M400\n<- ok");
    // Each drive has pushed its axis towards 0.
    for (std::size_t i = 0; i < axes.size(); ++i) {
      home[i] = static_cast<double>(printer.chip.mechanical[i]) + play_mm[i] * steps_per_mm[i];
      axes[i] = home[i];
    }
  }
  void talk(std::string_view dialogue) { printer.talk(dialogue); }
  // A motor pushes its axis at either end of the play.
  void follow() {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto motor = static_cast<double>(printer.chip.mechanical[i]);
      axes[i] = std::clamp(axes[i], motor, motor + play_mm[i] * steps_per_mm[i]);
    }
  }
  void go(const std::string& line) {
    talk("-> " + line + "\n<- ok\n-> M400\n<- ok");
    follow();
  }
  double place(std::size_t i) const { return (axes[i] - home[i]) / steps_per_mm[i]; }
  void expect_place(double at_x, double at_y, double at_z) const {
    EXPECT_NEAR(place(x), at_x, 0.5 / 80);
    EXPECT_NEAR(place(y), at_y, 0.5 / 80);
    EXPECT_NEAR(place(z), at_z, 0.5 / 2560);
  }

  Printer printer;
  std::array<double, 3> axes{}, home{};  // in steps
};

TEST_F(Backlash, leads_the_axes_to_their_places) {
  go("G1 X50 Y60 Z10 F6000");
  expect_place(50, 60, 10);
  go("G1 X40 Y70 Z9.9");
  expect_place(40, 70, 9.9);
  go("G1 X40.01 Y69.99 Z9.91");
  expect_place(40.01, 69.99, 9.91);
  talk("-> M114\n<- X:40.01 Y:69.99 Z:9.91 E:0.00 Count X:3201 Y:5599 Z:25370\n<- ok");
}

TEST_F(Backlash, adds_up_to_nothing) {
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    const auto to = [&] { return std::uniform_int_distribution(20, 40)(random); };
    const int to_x = to(), to_y = to(), to_z = to();
    go(fmt::format("G1 X{} Y{} Z{} F9000", to_x, to_y, to_z));
    expect_place(to_x, to_y, to_z);
  }
  talk("-> G28\n<- ok\n-> M400\n<- ok");
  follow();
  expect_place(0, 0, 0);
}

// X reverses twice, Y twice, in chords much shorter than the play.
TEST_F(Backlash, keeps_to_the_speed_of_each_motor_and_ends_exactly) {
  go("G1 X60 Y60 Z10 F6000");
  printer.send("G2 X60 Y60 I0.5 J0.5 F6000");
  printer.send("M400");
  std::array<double, 3> fastest{};
  auto before = printer.chip.mechanical;
  for (int i = 0; i < 3000; ++i) {
    const auto began = printer.chip.time;
    printer.run(0.001);
    const double seconds = static_cast<double>(printer.chip.time - began) / clock_hz;
    for (std::size_t axis = 0; axis < fastest.size(); ++axis) {
      const auto steps = static_cast<double>(printer.chip.mechanical[axis] - before[axis]);
      fastest[axis] = std::max(fastest[axis], (std::abs(steps) - 1) / seconds);
    }
    before = printer.chip.mechanical;
  }
  EXPECT_EQ(printer.reply(1), "ok");
  EXPECT_EQ(printer.reply(1), "ok");
  EXPECT_GT(fastest[x], 5 * 80);
  EXPECT_LE(fastest[x], 200 * 80);
  EXPECT_LE(fastest[y], 200 * 80);
  follow();
  go("G1 X70 Y70 Z10");
  expect_place(70, 70, 10);
}

TEST_F(Backlash, takes_up_as_much_as_f_says) {
  go("G1 X50 F6000");
  const auto there = printer.chip.mechanical[x];
  go("M425 F0.5");
  EXPECT_EQ(printer.chip.mechanical[x], there);
  go("G1 X40");
  EXPECT_EQ(there - printer.chip.mechanical[x], 10 * 80 + 8);
  go("M425 F0");
  go("G1 X50");
  EXPECT_EQ(printer.chip.mechanical[x] - (there - 10 * 80 - 8), 10 * 80);
  talk("-> M114\n<* X:50.00 Y:0.00 Z:0.00 E:0.00 Count X:4000 Y:0 Z:0\n<- ok");
}

// The place is off by the play at most until the axis moves, and then right.
TEST_F(Backlash, is_right_again_after_a_stop) {
  go("G1 X100 F6000");
  for (const char* line : {"G1 X20 F3000", "G1 X90 F3000"}) {
    talk(fmt::format("-> {}\n<- ok", line));
    printer.run(0.7);
    talk("-> M410\n<- ok");
    printer.run(0.3);
    follow();
    printer.send("M114");
    const std::string said = printer.reply().value_or("");
    EXPECT_EQ(printer.reply(), "ok");
    EXPECT_NEAR(std::stod(said.substr(2)), place(x), play_mm[x] + 0.02);
    go("G1 X60");
    EXPECT_NEAR(place(x), 60, 0.5 / 80);
  }
}

TEST_F(Backlash, is_reported_and_set_as_in_marlin) {
  talk(R"(
    -> M425
    <- Backlash Correction active:
    <-   Correction Amount/Fade-out:     F1.00 (F1.0 = full, F0.0 = none)
    <-   Backlash Distance (mm):         X0.200 Y0.150 Z0.050
    <- ok
    -> M425 X0.1 Z0 F0
    <- ok
    -> M425
    <- Backlash Correction inactive:
    <-   Correction Amount/Fade-out:     F0.00 (F1.0 = full, F0.0 = none)
    <-   Backlash Distance (mm):         X0.100 Y0.150 Z0.000
    <- ok
    -> M425 S3
    <- echo:M425 S without effect, there is no smoothing
    <- ok
    -> M425 X
    <- echo:X, Y or Z not within 0 to 5 mm, not executed: "M425 X"
    <- ok
    -> M425 Y5.1
    <- echo:X, Y or Z not within 0 to 5 mm, not executed: "M425 Y5.1"
    <- ok
    -> M502
    <- echo:Hardcoded Default Settings Loaded
    <- ok
    -> M425
    <- Backlash Correction active:
    <-   Correction Amount/Fade-out:     F1.00 (F1.0 = full, F0.0 = none)
    <-   Backlash Distance (mm):         X0.200 Y0.150 Z0.050
    <- ok
  )");
  printer.send("M503");
  std::string all;
  while (const auto line = printer.reply()) {
    if (*line == "ok") break;
    all += *line + "\n";
  }
  EXPECT_THAT(all, testing::EndsWith("echo: M425 F1.00 X0.200 Y0.150 Z0.050\n"));
}

}  // namespace
}  // namespace application_test
