// SPDX-License-Identifier: Apache-2.0
// A whole sliced file through planner and step model, read by a G-code reader of the test's own.
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <sstream>

#include "directories.hpp"
#include "tests/motion/print_run.hpp"

namespace {

// A decimal number of millimetres in nanometres, exactly (slicers write five decimals at most).
std::int64_t nanometers(std::string_view text) {
  const bool negative = text.starts_with('-');
  std::int64_t value = 0;
  int decimals = -1;
  for (const char c : text) {
    if (c == '.') decimals = 0;
    if (c < '0' || c > '9') continue;
    value = value * 10 + (c - '0');
    if (decimals >= 0) ++decimals;
  }
  for (int i = std::max(decimals, 0); i < 6; ++i) value *= 10;
  return negative ? -value : value;
}

// G0, G1, G28 (as going to 0) and G92 E of a file with absolute coordinates.
std::vector<motion::LineMove> moves_of(const std::string& file) {
  std::ifstream stream(file);
  std::vector<motion::LineMove> moves;
  units::PerAxis<units::Position> position{};
  units::Position extruder_origin{};
  std::int32_t um_per_s = 50'000;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line.substr(0, line.find(';')));
    std::string code;
    words >> code;
    std::map<char, std::int64_t> arguments;
    for (std::string word; words >> word;) arguments[word[0]] = nanometers(word.substr(1));
    if (code == "G92" && arguments.contains('E')) {
      extruder_origin = position[3] - units::Nanometers(arguments['E']);
    }
    if (code == "G28") position[0] = position[1] = position[2] = {};
    if (code == "G0" || code == "G1") {
      if (arguments.contains('F')) um_per_s = static_cast<std::int32_t>(arguments['F'] / 60'000);
      for (std::size_t i = 0; i < units::axis_count; ++i) {
        const char letter = units::axis_letters[i];
        if (!arguments.contains(letter)) continue;
        position[i] = units::Nanometers(arguments[letter]);
        if (letter == 'E') position[i] += extruder_origin;
      }
    } else if (code != "G28") {
      continue;
    }
    moves.push_back({.target = position, .feedrate = units::MicrometersPerSecond(um_per_s)});
  }
  return moves;
}

TEST(print, stays_within_a_step_of_the_lines_of_a_cube) {
  auto moves = moves_of(PROJECT_DIRECTORY "/examples/cube20_02_marlin.gcode");
  ASSERT_GT(moves.size(), 2'000u);
  moves.resize(2'000);
  motion_test::PrintRun run(motion_test::mendel(), {});
  const motion_test::RunResult result = run.run(moves);
  EXPECT_EQ(result.wrong_line_ends, 0u);
  EXPECT_LE(result.worst_distance_steps, 1.0);
  std::printf("worst: %.3f steps from the line\n", result.worst_distance_steps);
}

TEST(print, of_the_washer_is_exact_at_every_point_and_keeps_every_limit) {
  const auto moves = moves_of(PROJECT_DIRECTORY "/examples/washer.gcode");
  ASSERT_GT(moves.size(), 2'000u);
  motion_test::PrintRun run(motion_test::mendel(), {.lines_per_second = 400});
  const motion_test::RunResult result = run.run(moves);
  EXPECT_EQ(result.wrong_line_ends, 0u);
  EXPECT_EQ(result.underruns, 0u);
  EXPECT_LE(result.worst_distance_steps, 1.0);
  EXPECT_LE(result.worst_speed_excess, 1e-5);
  EXPECT_LE(result.worst_acceleration_excess, 1e-5);
  EXPECT_LE(result.worst_jump_excess_mm_s, 1e-3);
  EXPECT_LE(result.worst_rate_mismatch, 0.01);
  const motion::Limits limits = motion_test::mendel();
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const units::Position last = moves.back().target[i];
    EXPECT_EQ(result.final_steps[i],
              motion_test::exact_steps(last, limits.axes[i].steps_per_meter));
  }
  std::printf("%lu lines, %lu segments, %.1f s of motion, %lu rests, top %.0f mm/s\n", result.lines,
              result.segments, result.seconds, result.rests, result.highest_speed_mm_s);
  std::printf("worst: %.3f steps from the line, rates of phases %.1e\n",
              result.worst_distance_steps, result.worst_rate_mismatch);
}

}  // namespace
