// SPDX-License-Identifier: Apache-2.0
// The judge of lines above a mesh: a printer that follows it is good, and each fault in it is bad.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "sim/report/point_check.hpp"

namespace {

using Heights = std::array<std::array<double, 3>, 3>;  // row by row
using Place = std::array<double, 3>;

constexpr std::array<double, 2> first{25, 10}, apart{90, 95};  // of the mesh
constexpr double fade_mm = 10;
constexpr Heights uneven{{{0.1, -0.2, 0.05}, {-0.15, 0.3, 0.2}, {0.25, -0.1, -0.3}}};

// Each point counts in full where it is, and linearly less to its neighbours.
double height_of(const Heights& heights, double x, double y) {
  x = std::clamp(x, first[0], first[0] + 2 * apart[0]);
  y = std::clamp(y, first[1], first[1] + 2 * apart[1]);
  double sum = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const double off_x =
          std::abs(x - first[0] - apart[0] * static_cast<double>(column)) / apart[0];
      const double off_y = std::abs(y - first[1] - apart[1] * static_cast<double>(row)) / apart[1];
      sum += heights[row][column] * std::max(0.0, 1 - off_x) * std::max(0.0, 1 - off_y);
    }
  }
  return sum;
}

double faded(double height, double z, double end = fade_mm) {
  return height * std::clamp(1 - z / end, 0.0, 1.0);
}

double bed(double x, double y) { return 0.0017 * x - 0.0013 * y + 0.0511; }

report::MachineFacts facts_with_probe() {
  report::MachineFacts facts;
  facts.travel.fill(250 * report::femtometers_per_mm);
  facts.steps_per_mm = {80, 80, 400};
  facts.probe = report::ProbeFacts{{25, -10, -1.2}, 4, {}, fade_mm, bed};
  for (std::size_t i = 0; i < 2; ++i) {
    facts.probe->lines[i] = {first[i], first[i] + 2 * apart[i], 3};
  }
  return facts;
}

// Walks each line in parts of at most 0.02 mm, with what `added` says above it.
class LevelledPrint : public testing::Test {
 protected:
  using Added = std::function<double(const Place&)>;

  LevelledPrint() {
    begin("G28");
    walk_to({0, 0, 0}, level);
    check.command_acknowledged(++clock, file_line, "", true);
  }
  void send(const std::string& command) {
    begin(command);
    check.command_acknowledged(++clock, file_line, "", true);
  }
  void begin(const std::string& command) { check.command_sent(++clock, ++file_line, command); }
  void line(const std::string& command, const Place& to, const Added& added) {
    send(command);
    walk_to(to, added);
  }
  void walk_to(const Place& to, const Added& added) {
    const Place from = here;
    const double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    const int parts = 1 + static_cast<int>(length / 0.02);
    for (int part = 1; part <= parts; ++part) {
      for (std::size_t i = 0; i < to.size(); ++i) {
        here[i] = part == parts ? to[i] : from[i] + (to[i] - from[i]) * part / parts;
      }
      move_motors({here[0], here[1], here[2] + added(here)});
    }
  }
  void move_motors(const Place& nozzle) {
    clock += 100;
    for (std::size_t i = 0; i < nozzle.size(); ++i) {
      const std::int64_t wanted = std::llround(nozzle[i] * steps_per_mm[i]);
      while (position[i] != wanted) {
        const int direction = wanted > position[i] ? 1 : -1;
        position[i] += direction;
        check.stepped({clock, i, direction, position[i]});
      }
    }
  }
  // M421 for all points.
  void tell_mesh(const Heights& heights) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        send("M421 I" + std::to_string(column) + " J" + std::to_string(row) + " Z" +
             std::to_string(heights[row][column]));
      }
    }
  }
  // Across all cells, on and below the end of fading.
  void print(const Added& added) {
    tell_mesh(uneven);
    send("G1 Z12");
    walk_to({0, 0, 12}, level);
    send("M420 S1");
    line("G1 X30 Y20 Z12", {30, 20, 12}, added);
    line("G1 Z0.3", {30, 20, 0.3}, added);
    line("G1 X200 Y21", {200, 21, 0.3}, added);
    line("G1 X190 Y190", {190, 190, 0.3}, added);
    line("G1 X40 Y30 Z3", {40, 30, 3}, added);
    line("G1 X45 Y205", {45, 205, 3}, added);
    send("M400");
  }
  std::uint64_t missed() const { return check.judgement().missed; }
  std::int64_t unasked() const { return check.judgement().unasked_steps[2]; }
  bool good() const { return missed() == 0 && unasked() == 0 && check.max_height_error_mm() == 0; }

  static double level(const Place&) { return 0; }
  static double right(const Place& at) { return faded(height_of(uneven, at[0], at[1]), at[2]); }

  static constexpr std::array<double, 4> steps_per_mm{80, 80, 400, 500};
  Place here{5, 6, 7};
  report::Steps position{400, 480, 2800, 0};
  std::uint64_t clock = 0;
  std::size_t file_line = 0;
  report::PointCheck check{
      steps_per_mm, {400, 480, 2800, 0}, sim::ClockRate(4'000'000), facts_with_probe()};
};

TEST_F(LevelledPrint, is_good_where_it_follows_the_mesh) {
  print(right);
  EXPECT_EQ(missed(), 0u);
  EXPECT_EQ(unasked(), 0);
  EXPECT_EQ(check.max_height_error_mm(), 0.0);
  EXPECT_EQ(check.lines_apart(), 0u);
  EXPECT_EQ(check.judgement().reached, 7u);
}

TEST_F(LevelledPrint, is_bad_where_the_mesh_is_not_taken) {
  print(level);
  EXPECT_GE(missed(), 4u);  // a line straight down comes by the right height
  EXPECT_GT(check.max_height_error_mm(), 0.1);
}

TEST_F(LevelledPrint, is_bad_with_the_sign_reversed) {
  print([](const Place& at) { return -right(at); });
  EXPECT_GE(missed(), 4u);
}

TEST_F(LevelledPrint, is_bad_with_the_heights_of_the_next_cell) {
  print([](const Place& at) { return faded(height_of(uneven, at[0] + apart[0], at[1]), at[2]); });
  EXPECT_GE(missed(), 4u);
}

TEST_F(LevelledPrint, is_bad_with_columns_and_rows_exchanged) {
  print([](const Place& at) {
    const double x = first[0] + (at[1] - first[1]) * apart[0] / apart[1];
    const double y = first[1] + (at[0] - first[0]) * apart[1] / apart[0];
    return faded(height_of(uneven, x, y), at[2]);
  });
  EXPECT_GE(missed(), 3u);
}

TEST_F(LevelledPrint, is_bad_where_nothing_fades) {
  print([](const Place& at) { return height_of(uneven, at[0], at[1]); });
  EXPECT_GE(missed(), 5u);
}

TEST_F(LevelledPrint, is_bad_where_it_fades_at_another_height) {
  print([](const Place& at) { return faded(height_of(uneven, at[0], at[1]), at[2], 9); });
  EXPECT_GE(missed(), 1u);
}

// All ends are right, and nothing between them is.
TEST_F(LevelledPrint, is_bad_where_lines_are_not_cut_at_the_cells) {
  tell_mesh(uneven);
  send("G1 Z12");
  walk_to({0, 0, 12}, level);
  send("M420 S1");
  line("G1 X30 Y20", {30, 20, 12}, level);
  line("G1 Z0.3", {30, 20, 0.3}, right);
  const double from = right({30, 20, 0.3}), to = right({200, 21, 0.3});
  line("G1 X200 Y21", {200, 21, 0.3},
       [&](const Place& at) { return from + (to - from) * (at[0] - 30) / 170; });
  send("M400");
  EXPECT_EQ(missed(), 0u);
  EXPECT_GT(check.max_height_error_mm(), 0.1);
}

TEST_F(LevelledPrint, is_bad_a_step_off_the_height) {
  print([](const Place& at) { return right(at) + 0.0026; });
  EXPECT_GE(missed(), 5u);
}

TEST_F(LevelledPrint, follows_what_m420_and_m421_change) {
  print(right);
  const Place before = here;
  const double nozzle = here[2] + right(here);
  // Z is called otherwise where the nozzle is.
  send("M420 S0");
  here = {before[0], before[1], nozzle};
  line("G1 X50 Z3", {50, 205, 3}, level);
  send("M420 Z0");
  send("M421 I0 J-1 Q0.1");
  Heights changed = uneven;
  for (auto& row : changed) row[0] += 0.1;
  send("M420 S1");
  const auto unfaded = [&](const Place& at) { return height_of(changed, at[0], at[1]); };
  here[2] -= unfaded(here);
  line("G1 X30 Y30 Z20", {30, 30, 20}, unfaded);
  begin("G28 X");
  here[2] += unfaded(here);
  walk_to({0, 30, here[2]}, level);
  check.command_acknowledged(++clock, file_line, "", true);
  EXPECT_TRUE(good()) << missed() << " " << unasked() << " " << check.max_height_error_mm();
  line("G1 Y100 Z1", {0, 100, 1}, unfaded);  // homing has ended it
  send("M400");
  EXPECT_FALSE(good());
}

class ProbedPrint : public LevelledPrint {
 protected:
  // The heights of steps at which the probe triggers.
  static Heights probed(double error_mm = 0) {
    Heights heights{};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        const double height = bed(first[0] + apart[0] * static_cast<double>(column),
                                  first[1] + apart[1] * static_cast<double>(row));
        heights[row][column] = std::floor(height * 400) / 400 + error_mm;
      }
    }
    return heights;
  }
  // It ends with the probe at the last of nine points, there and back.
  void probe(const Heights& heights, double end_z = 4) {
    begin("G29");
    walk_to({180, 210, 1.4}, level);
    walk_to({180, 210, end_z}, level);
    check.command_acknowledged(++clock, file_line, "", true);
    const double height = height_of(heights, here[0], here[1]);
    here[2] = (here[2] - height) / (1 - height / fade_mm);
  }
  void print_on(const Heights& heights) {
    const auto added = [&](const Place& at) {
      return faded(height_of(heights, at[0], at[1]), at[2]);
    };
    line("G1 X30 Y20 Z0.3", {30, 20, 0.3}, added);
    line("G1 X200 Y190", {200, 190, 0.3}, added);
    line("G1 X100 Y20", {100, 20, 0.3}, added);
    send("M400");
  }
};

TEST_F(ProbedPrint, is_good_with_the_heights_at_which_the_probe_triggers) {
  probe(probed());
  print_on(probed());
  EXPECT_EQ(missed(), 0u);
  EXPECT_TRUE(good());
}

TEST_F(ProbedPrint, is_bad_with_heights_a_step_off_those) {
  probe(probed());
  print_on(probed(0.0025));
  EXPECT_EQ(missed(), 3u);
}

TEST_F(ProbedPrint, is_bad_where_probing_ends_elsewhere) {
  probe(probed(), 5);
  EXPECT_EQ(missed(), 1u);
}

}  // namespace
