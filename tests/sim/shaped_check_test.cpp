// SPDX-License-Identifier: Apache-2.0
// A print made exactly as firmware/motion/shaping.md describes is judged good, whatever its lines.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "shaped_faults.hpp"
#include "shaped_program.hpp"

namespace tests {

namespace {

using Write = void (*)(ProgramWriter&);
struct Case {
  const char* name;
  Write write;
};

constexpr std::array cases{
    Case{"a long line and back on it",
         [](ProgramWriter& file) {
           file.line(60, 0, 0, 2);
           file.line(-60, 0, 0, 2);
           file.line(60, 0);
           file.line(-30, 0, 0, 1);
         }},
    Case{"a square",
         [](ProgramWriter& file) {
           for (const auto& [x, y] : {std::pair{20, 0}, {0, 20}, {-20, 0}, {0, -20}}) {
             file.line(x, y, 0, 0.8);
           }
         }},
    Case{"a sharp corner",
         [](ProgramWriter& file) {
           file.line(40, 1, 0, 1.6);
           file.line(-40, 1, 0, 1.6);
           file.line(40, 0.02, 0, 1.6);
         }},
    Case{"short lines",
         [](ProgramWriter& file) {
           for (int i = 0; i < 300; ++i) {
             file.line(0.05 * std::cos(i * 0.02), 0.05 * std::sin(i * 0.02), 0, 0.002);
           }
         }},
    Case{"lines shorter than a step, forth and back",
         [](ProgramWriter& file) {
           for (int i = 0; i < 200; ++i) file.line(i % 2 == 0 ? 0.009 : -0.008, 0.004, 0, 0.0005);
         }},
    Case{"infill between lines that are near",
         [](ProgramWriter& file) {
           for (int i = 0; i < 30; ++i) {
             file.line(i % 2 == 0 ? 1.5 : -1.5, 0, 0, 0.06);
             file.line(0, 0.4, 0, 0.016);
           }
         }},
    Case{"the same small move again and again",
         [](ProgramWriter& file) {
           for (int i = 0; i < 40; ++i) file.line(i % 2 == 0 ? 0.3 : -0.3, 0, 0, 0.01);
           file.rest();
         }},
    Case{"circles, with and without filament, and helical",
         [](ProgramWriter& file) {
           file.arc(5, 0, 6.29, 0, 1.2);
           file.arc(0, -3, -6.29);
           file.arc(0.2, 0.1, 6.29, 0, 0.05);
           file.arc(4, 4, 6.29, 0.4, 1);
           file.line(10, 0, 0, 0.4);
           file.arc(0, 6, 1.5, 0, 0.4);
           file.arc(-6, 1, -4, 0.2, 0.8);
         }},
    Case{"retractions with a hop",
         [](ProgramWriter& file) {
           for (int i = 0; i < 3; ++i) {
             file.line(15, 8, 0, 0.7);
             file.line(0, 0, 0, -1);
             file.line(0, 0, 0.4);
             file.line(-12, 3);
             file.line(0, 0, -0.4);
             file.line(0, 0, 0, 1);
           }
         }},
    Case{"retractions by G10, and one while it wipes",
         [](ProgramWriter& file) {
           file.line(15, 8, 0, 0.7);
           file.retract_by_code();
           file.line(10, 8);
           file.recover_by_code();
           file.line(15, 8, 0, 0.7);
           file.line(-3, 0, 0, -0.6);
           file.line(20, 0);
           file.line(0, 0, 0, 0.6);
           file.line(0, 5, 0, 0.2);
         }},
    Case{"pauses and rests",
         [](ProgramWriter& file) {
           file.line(10, 0, 0, 0.4);
           file.dwell(0.2);
           file.line(0, 10, 0, 0.4);
           file.dwell(0.004);
           file.line(10, 0, 0, 0.4);
           file.rest();
           file.rest();
           file.line(-10, 5, 0, 0.4);
           file.rest();
         }},
    Case{"lines with no motion",
         [](ProgramWriter& file) {
           for (int axis = 0; axis < 4; ++axis) file.line(0, 0, 0, 0, axis);
           file.line(10, 0, 0, 0.4);
           for (int axis = 0; axis < 4; ++axis) file.line(0, 0, 0, 0, axis);
           file.line(0, 10, 0, 0.4);
           file.rest();
           file.line(0, 0, 0, 0, 0);
         }},
    Case{"other names for places, in inches, relative, at another speed",
         [](ProgramWriter& file) {
           file.name_place(0, -30);
           file.name_place(3, 0);
           file.line(10, 5, 0, 0.4);
           file.inches(true);
           file.feed(30);
           file.line(10, -5, 0, 0.4);
           file.relative(true);
           file.line(-10, 5, 0, 0.4);
           file.percent(180);
           file.line(10, 5, 0, 0.4);
           file.inches(false);
           file.line(-10, 5, 0, 0.4);
           file.relative(false);
           file.line(10, 5, 0, 0.4);
         }},
    Case{"other shapers on the way",
         [](ProgramWriter& file) {
           file.line(20, 5, 0, 0.8);
           const ShaperChoice mzv{"mzv", 25, 0.05};
           file.shape("M593 F25 D0.05 P\"MZV\"", {mzv, mzv, 0});
           file.shape("M900 K0.06", {mzv, mzv, 0.06});
           file.line(-10, 5, 0, 0.4);
           file.shape("M900 K0", {mzv, mzv, 0});
           file.line(10, 5, 0, 0.4);
           file.shape("M593 F0", {});
           file.line(-10, 5, 0, 0.4);
           file.shape("M572 S0.02", {{}, {}, 0.02});
           file.line(10, 5, 0, 0.4);
         }},
};

class ShapedCheckOf : public testing::TestWithParam<Case> {};

// Each of the shapers, others on X and Y, linear advance alone, and both.
const std::vector<ShapingChoice>& choices() {
  static const std::vector<ShapingChoice> all = [] {
    std::vector<ShapingChoice> made;
    for (const char* kind : {"zv", "zvd", "mzv", "ei", "2hump_ei"}) {
      made.push_back({{kind, 36, 0.1}, {kind, 36, 0.1}, 0});
      made.push_back({{kind, 20, 0}, {"zv", 40, 0.2}, 0.05});
    }
    made.push_back({{}, {}, 0.08});
    made.push_back({{}, {"2hump_ei", 30, 0.1}, 0.03});
    return made;
  }();
  return all;
}

TEST_P(ShapedCheckOf, judges_them_good) {
  for (const double clock_hz : {4e6, 50e6}) {
    for (const double jerk : {4., 40.}) {
      for (const ShapingChoice& choice : choices()) {
        const PlanLimits limits{.jerk_mm_s = {jerk, jerk, 1, jerk},
                                .acceleration_mm_s2 = jerk * 400};
        ProgramWriter file(limits);
        file.feed(80);
        file.line(50, 50);
        GetParam().write(file);
        ShapedPrinter printer(clock_hz, choice, limits);
        printer.run(file.commands());
        EXPECT_EQ(complaint_of(printer, file.commands()), "")
            << choice.x.kind << " " << choice.y.kind << " " << choice.advance_s << " at "
            << clock_hz;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Lines, ShapedCheckOf, testing::ValuesIn(cases),
                         [](const testing::TestParamInfo<Case>& test) {
                           std::string name = test.param.name;
                           std::erase(name, ',');
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

}  // namespace

TEST(ShapedCheck, judges_random_programs_good) {
  int bad = 0, listed = 0;

  std::vector<std::uint32_t> seeds(1000);
  std::iota(seeds.begin(), seeds.end(), 0);
  // E a step early over the time of linear advance, and arcs that turn by less than a step.
  for (const std::uint32_t rare : {11019u, 11707u, 12613u, 13629u, 20305u, 20317u}) {
    seeds.push_back(rare);
  }
  for (const std::uint32_t seed : seeds) {
    const double clock_hz = seed % 2 == 0 ? 4e6 : 50e6;
    const RandomProgram program(seed, clock_hz, seed % 3 == 2);
    ShapedPrinter printer(clock_hz, program.given(), program.limits(), program.buffered());
    printer.run(program.commands());
    const std::string complaint = complaint_of(printer, program.commands());
    if (complaint.empty()) continue;
    ++bad;
    if (++listed <= 25) {
      const auto& given = program.given();
      fmt::print("seed {} x {} {} y {} {} K {} jerk {} : {}\n", seed, given.x.kind, given.x.hertz,
                 given.y.kind, given.y.hertz, given.advance_s, program.limits().jerk_mm_s[0],
                 complaint);
    }
  }
  EXPECT_EQ(bad, 0);
}

}  // namespace tests
