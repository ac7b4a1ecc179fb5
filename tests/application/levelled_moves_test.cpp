// SPDX-License-Identifier: Apache-2.0
// Where the nozzle goes while lines follow the mesh, and what the host sees of it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "tests/application/probed_printer.hpp"

namespace application_test {
namespace {

using testing::HasSubstr;

class LevelledMoves : public ProbedPrinter {
 protected:
  LevelledMoves() { home(); }

  void level() {
    answer("G29 X5 Y5");
    EXPECT_THAT(answer("M420 Z0"), HasSubstr("ON"));
  }
  // Of the mesh that level() makes.
  static double height(double at_x, double at_y) {
    const double part_x = std::clamp((at_x - 30) / 40, 0.0, 4.0);
    const double part_y = std::clamp((at_y - 10) / 42.5, 0.0, 4.0);
    const double i = std::min(std::floor(part_x), 3.0), j = std::min(std::floor(part_y), 3.0);
    const auto point = [](double column, double row) {
      return uneven(30 + 40 * column, 10 + 42.5 * row);
    };
    const double u = part_x - i, v = part_y - j;
    return (point(i, j) * (1 - u) + point(i + 1, j) * u) * (1 - v) +
           (point(i, j + 1) * (1 - u) + point(i + 1, j + 1) * u) * v;
  }
  // Sends a line, and looks until its end how far the nozzle leaves this height above the mesh.
  double worst_height(const std::string& line, double above) {
    printer.talk("-> " + line + "\n<- ok");
    printer.send("M400");
    double worst = 0;
    do {
      worst =
          std::max(worst, std::abs(printer.mm(z) - above - height(printer.mm(x), printer.mm(y))));
    } while (!printer.reply(0.002));
    return worst;
  }
  void execute(std::initializer_list<std::string> lines) {
    for (const std::string& line : lines) printer.talk("-> " + line + "\n<- ok\n");
    printer.talk("-> M400\n<- ok\n");
  }
};

// Chords of 10 um, heights of probing and steps of X and Y on the slope.
constexpr double tolerance = 0.012;

TEST_F(LevelledMoves, keep_their_height_above_the_bed) {
  level();
  execute({"G1 X5 Y5 Z0.3 F6000"});
  double worst = worst_height("G1 X190 Y180 F4800", 0.3);
  worst = std::max(worst, worst_height("G1 X20", 0.3));
  worst = std::max(worst, worst_height("G1 X60 Y20", 0.3));
  worst = std::max(worst, worst_height("G2 X60 Y20 I30 J40", 0.3));
  worst = std::max(worst, worst_height("G1 X199 Y199", 0.3));
  std::mt19937 random(1);
  const auto place = [&] { return std::uniform_real_distribution(0.0, 199.0)(random); };
  for (int i = 0; i < 10; ++i) {
    worst = std::max(worst, worst_height(fmt::format("G1 X{:.3f} Y{:.3f}", place(), place()), 0.3));
  }
  EXPECT_LT(worst, tolerance);
  EXPECT_EQ(printer.chip.underruns, 0u);
  std::printf("at most %.1f um off\n", worst * 1000);
  // Without the mesh they do not.
  answer("M420 S0");
  execute({"G1 X5 Y5 Z0.3"});
  EXPECT_GT(worst_height("G1 X190 Y180", 0.3), 0.2);
}

TEST_F(LevelledMoves, fade_with_height) {
  level();
  answer("M420 Z4");
  for (const double at_z : {0.0, 0.2, 1.0, 3.0, 3.9, 4.0, 4.1, 20.0}) {
    for (const double at_x : {40.0, 97.5}) {
      execute({fmt::format("G1 X{:.3f} Y33 Z{:.3f} F6000", at_x, at_z)});
      const double part = std::clamp(1 - at_z / 4, 0.0, 1.0);
      EXPECT_NEAR(printer.mm(z), at_z + height(at_x, 33) * part, 0.002) << at_z;
    }
  }
}

TEST_F(LevelledMoves, are_where_the_host_believes) {
  level();
  execute({"G1 X50 Y60 Z0.4 F6000", "G91", "G1 X33.333 Y-10.1", "G1 Z0.2",
           "G1 X-33.333 Y10.1 Z-0.2", "G90"});
  EXPECT_THAT(answer("M114"), HasSubstr("X:50.00 Y:60.00 Z:0.40 "));
  EXPECT_NEAR(printer.mm(z), 0.4 + height(50, 60), 0.002);
  // Switching changes what the host sees, and moves nothing.
  const auto before = printer.chip.mechanical;
  answer("M420 S0");
  EXPECT_THAT(answer("M114"),
              HasSubstr(fmt::format("X:50.00 Y:60.00 Z:{:.2f} ", 0.4 + height(50, 60))));
  answer("M420 S1");
  EXPECT_THAT(answer("M114"), HasSubstr("X:50.00 Y:60.00 Z:0.40 "));
  for (int i = 0; i < 20; ++i) {
    answer("M420 S0");
    answer("M420 S1");
  }
  EXPECT_EQ(printer.chip.mechanical, before);
  execute({"G92 Z1", "G1 X120 Z1.1"});
  EXPECT_NEAR(printer.mm(z), 0.5 + height(120, 60), 0.002);
}

TEST_F(LevelledMoves, are_bound_by_the_limits_of_the_line_not_of_the_nozzle) {
  answer("M421 Z-0.5");
  answer("M420 S1 Z0");
  execute({"G1 X50 Y60 Z0 F6000"});
  EXPECT_NEAR(printer.mm(z), -0.5, 0.002);
  EXPECT_THAT(answer("G1 Z-0.1"), HasSubstr("Move beyond the end of Z"));
  EXPECT_NEAR(printer.mm(z), -0.5, 0.002);
}

TEST_F(LevelledMoves, are_found_again_after_a_quick_stop) {
  level();
  execute({"G1 X5 Y5 Z0.3 F6000"});
  printer.talk("-> G1 X190 Y180 F3000\n<- ok");
  printer.run(2);
  printer.talk("-> M410\n<- ok");
  printer.run(0.1);
  const double at_x = printer.mm(x), at_y = printer.mm(y);
  EXPECT_GT(at_x, 40);
  EXPECT_LT(at_x, 170);
  const std::string place = answer("M114");
  double x_said = 0, y_said = 0, z_said = 0;
  ASSERT_EQ(std::sscanf(place.c_str(), "X:%lf Y:%lf Z:%lf", &x_said, &y_said, &z_said), 3) << place;
  EXPECT_NEAR(x_said, at_x, 0.01);
  EXPECT_NEAR(y_said, at_y, 0.01);
  EXPECT_NEAR(z_said, 0.3, 0.005);
  execute({"G1 X100 Y100 Z0.3"});
  EXPECT_NEAR(printer.mm(x), 100, 0.01);
  EXPECT_NEAR(printer.mm(z), 0.3 + height(100, 100), 0.002);
}

TEST_F(LevelledMoves, end_with_homing) {
  level();
  execute({"G1 X50 Y60 Z2 F6000", "G28 X"});
  EXPECT_THAT(answer("M114"),
              HasSubstr(fmt::format("X:0.00 Y:60.00 Z:{:.2f} ", 2 + height(50, 60))));
  execute({"G1 X80 Z1"});
  EXPECT_NEAR(printer.mm(z), 1, 0.002);
  execute({"G28"});
  for (const std::size_t axis : {x, y, z}) EXPECT_LE(std::abs(printer.chip.mechanical[axis]), 1);
  EXPECT_THAT(answer("M420 S1"), HasSubstr("ON"));  // the mesh is still there
}

// The mesh makes Z as fast as a line along X wants; the axis' own limit holds.
TEST_F(LevelledMoves, keep_to_the_speed_of_z) {
  for (int column = 0; column < 5; ++column) {
    answer(fmt::format("M421 I{} Z{}", column, column % 2 == 0 ? 0 : 5));
  }
  answer("M420 S1 Z0");
  execute({"G1 X10 Y60 Z1 F6000"});
  printer.talk("-> G1 X190 F12000\n<- ok\n-> M400");
  double before, fastest = 0;
  do {
    before = printer.mm(z);
    const auto began = printer.chip.time;
    printer.run(0.02);
    const double seconds = static_cast<double>(printer.chip.time - began) / clock_hz;
    fastest = std::max(fastest, std::abs(printer.mm(z) - before) / seconds);
  } while (!printer.reply(0.0001));
  const double limit = machine().limits.axes[z].max_speed.count() / 1000.0;
  EXPECT_LT(fastest, limit * 1.05);
  EXPECT_GT(fastest, limit * 0.5);
}

// A line of a job, with number and checksum.
std::string framed(int number, const std::string& line) {
  const std::string text = fmt::format("N{} {}", number, line);
  unsigned sum = 0;
  for (const char byte : text) sum ^= static_cast<unsigned char>(byte);
  return fmt::format("{}*{}", text, sum);
}

// Planned at twice its speed, a line under way becomes four times as slow with a person's M220 S50,
// all of its chords; those behind it are planned at what they request, and become twice as slow.
TEST_F(LevelledMoves, are_slowed_down_as_a_whole) {
  // So rugged that a line has more chords than the planner holds.
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 5; ++column) {
      answer(fmt::format("M421 I{} J{} Z{}", column, row, (row + column) % 2 == 0 ? 0 : 4));
    }
  }
  answer("M420 S1 Z0");
  execute({"G1 X30 Y10 Z1 F6000"});
  int number = 0;
  const auto job = [&](const std::string& line) {
    printer.chip.from_firmware.clear();  // an ok that was repeated for a host that seemed to wait
    printer.talk("-> " + framed(number++, line) + "\n<- ok");
  };
  const auto speed = [&](double seconds) {
    const double before = printer.mm(x);
    printer.run(seconds);
    return (printer.mm(x) - before) / seconds;
  };
  job("M110 N0");
  number = 1;
  job("M220 S200");
  job("G1 X190 Y180 F600");
  printer.run(1);
  const double planned = speed(1);
  EXPECT_NEAR(planned, 20 * 160 / std::hypot(160, 170), 1.5);
  printer.talk("-> M220 S50\n<- ok");
  printer.send(framed(number++, "G1 X30 Y10"));
  while (printer.mm(x) < 182) {
    const double before = printer.mm(x);
    ASSERT_NEAR(speed(1), planned / 4, planned / 16) << "from " << before;
  }
  printer.run(15);
  EXPECT_NEAR(speed(1), -planned / 4, planned / 16);
  printer.talk("<- ok");
}

TEST_F(LevelledMoves, are_refused_where_they_are_too_long_for_the_arithmetic) {
  level();
  printer.talk("-> M211 S0\n<- ok");
  EXPECT_THAT(answer("G1 X3000"), HasSubstr("move too long"));
  EXPECT_THAT(answer("M114"), HasSubstr("X:"));
}

}  // namespace
}  // namespace application_test
