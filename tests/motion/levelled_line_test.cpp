// SPDX-License-Identifier: Apache-2.0
// The path above an uneven bed against a bilinear surface in floating point: heights, chords of
// lines in all directions, what fades, and the way back from the nozzle to Z.
#include "motion/levelled_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using motion::BedMesh;
using motion::LevelledLine;
using motion::LineMove;
using motion::MeshAxis;
using units::Nanometers;
using units::Position;
using Place = units::PerAxis<Position>;

constexpr double nm = 1e-6, um = 1e-3;  // in mm
constexpr double height_tolerance = 5 * nm;
constexpr double most_deviation = 10 * um;  // the requirement

Nanometers from_mm(double mm) { return Nanometers(std::llround(mm * 1e6)); }
double to_mm(const Position& position) {
  return static_cast<double>(position.whole().count()) * 1e-6 + position.femtometers() * 1e-12;
}

// The surface as the requirement says it: bilinear between the points, clamped beyond them, and
// with less of it the higher Z is, none from the fade height on.
struct Surface {
  double first[2], last[2];
  std::size_t points[2];
  std::vector<double> heights;  // row by row
  double fade{};

  double height(double x, double y) const {
    double part[2];
    std::size_t cell[2];
    const double place[2] = {x, y};
    for (int axis = 0; axis < 2; ++axis) {
      const double size = (last[axis] - first[axis]) / static_cast<double>(points[axis] - 1);
      const double at = std::clamp(place[axis], first[axis], last[axis]) - first[axis];
      cell[axis] = std::min(static_cast<std::size_t>(at / size), points[axis] - 2);
      part[axis] = at / size - static_cast<double>(cell[axis]);
    }
    const auto of = [&](std::size_t i, std::size_t j) {
      return heights[(cell[1] + j) * points[0] + cell[0] + i];
    };
    return of(0, 0) * (1 - part[0]) * (1 - part[1]) + of(1, 0) * part[0] * (1 - part[1]) +
           of(0, 1) * (1 - part[0]) * part[1] + of(1, 1) * part[0] * part[1];
  }
  double correction(double x, double y, double z) const {
    const double all = height(x, y);
    if (fade == 0 || z <= 0) return all;
    return z >= fade ? 0 : all * (1 - z / fade);
  }
};

class Random {
 public:
  explicit Random(unsigned seed) : numbers_(seed) {}
  double within(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(numbers_);
  }
  std::size_t below(std::size_t end) { return numbers_() % end; }

  // Grids of all sizes, from nearly flat to steeper than any bed.
  Surface surface() {
    Surface surface;
    for (int axis = 0; axis < 2; ++axis) {
      surface.first[axis] = std::round(within(-20, 60) * 1e6) * 1e-6;
      surface.last[axis] = surface.first[axis] + std::round(within(10, 300) * 1e6) * 1e-6;
      surface.points[axis] = 2 + below(14);
    }
    const double size = std::pow(10, within(-2, 0.9));
    for (std::size_t i = 0; i < surface.points[0] * surface.points[1]; ++i) {
      surface.heights.push_back(std::round(within(-size, size) * 1e6) * 1e-6);
    }
    if (below(3) != 0) surface.fade = std::round(within(2 * size, 2 * size + 20) * 1e6) * 1e-6;
    return surface;
  }
  Place place() {
    Place place{from_mm(within(-60, 260)), from_mm(within(-60, 260)), from_mm(within(-3, 30)),
                from_mm(within(0, 100))};
    if (below(2) == 0) place[2] = from_mm(within(-0.5, 2));
    return place;
  }

 private:
  std::mt19937 numbers_;
};

BedMesh mesh_of(const Surface& surface) {
  BedMesh mesh;
  std::array<MeshAxis, 2> axes;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    axes[axis] = {.first = from_mm(surface.first[axis]),
                  .last = from_mm(surface.last[axis]),
                  .points = static_cast<std::uint8_t>(surface.points[axis])};
  }
  mesh.set_axes(axes);
  for (std::size_t row = 0; row < surface.points[1]; ++row) {
    for (std::size_t column = 0; column < surface.points[0]; ++column) {
      EXPECT_FALSE(mesh.complete());
      EXPECT_TRUE(
          mesh.set_height(column, row, from_mm(surface.heights[row * surface.points[0] + column])));
    }
  }
  EXPECT_TRUE(mesh.complete());
  mesh.set_fade_height(from_mm(surface.fade));
  return mesh;
}

double correction(const Surface& surface, const Place& place) {
  return surface.correction(to_mm(place[0]), to_mm(place[1]), to_mm(place[2]));
}

TEST(bed_mesh, is_the_bilinear_surface_everywhere) {
  Random random(1);
  double worst = 0;
  for (int meshes = 0; meshes < 300; ++meshes) {
    const Surface surface = random.surface();
    const BedMesh mesh = mesh_of(surface);
    for (int places = 0; places < 200; ++places) {
      Place place = random.place();
      // On the lines of the grid too, where two cells meet.
      if (random.below(4) == 0) place[0] = mesh.line(0, random.below(mesh.points(0)));
      if (random.below(4) == 0) place[1] = mesh.line(1, random.below(mesh.points(1)));
      const double off = std::abs(to_mm(mesh.correction(place)) - correction(surface, place));
      worst = std::max(worst, off);
      ASSERT_LT(off, height_tolerance + 3 * nm) << "mesh " << meshes;
    }
  }
  std::printf("at most %.1f nm off\n", worst / nm);
}

TEST(bed_mesh, finds_z_where_the_nozzle_is) {
  Random random(2);
  for (int meshes = 0; meshes < 300; ++meshes) {
    const BedMesh mesh = mesh_of(random.surface());
    for (int places = 0; places < 100; ++places) {
      const Place place = random.place();
      Place nozzle = place;
      nozzle[2] += mesh.correction(place);
      ASSERT_NEAR(to_mm(mesh.uncorrected_z(nozzle)), to_mm(place[2]), 3 * nm) << "mesh " << meshes;
    }
  }
}

TEST(bed_mesh, knows_what_it_does_not_know) {
  BedMesh mesh;
  EXPECT_FALSE(mesh.complete());
  mesh.set_axes({{{from_mm(0), from_mm(10), 2}, {from_mm(0), from_mm(10), 2}}});
  EXPECT_FALSE(mesh.complete());
  for (const std::size_t point : {0UZ, 1UZ, 2UZ}) {
    EXPECT_TRUE(mesh.set_height(point % 2, point / 2, {}));
  }
  EXPECT_FALSE(mesh.complete());
  EXPECT_FALSE(mesh.height(1, 1).has_value());
  EXPECT_FALSE(mesh.set_height(1, 1, from_mm(10.1)));
  EXPECT_FALSE(mesh.set_height(1, 1, from_mm(-10.1)));
  EXPECT_FALSE(mesh.complete());
  EXPECT_TRUE(mesh.set_height(1, 1, from_mm(-2.5)));
  EXPECT_TRUE(mesh.complete());
  EXPECT_EQ(mesh.largest(), from_mm(2.5));
  mesh.set_fade_height(from_mm(4.9));
  EXPECT_FALSE(mesh.fades_slowly());
  mesh.set_fade_height(from_mm(5));
  EXPECT_TRUE(mesh.fades_slowly());
}

// The chords of a line, from its begin.
std::vector<Place> chords_of(const BedMesh& mesh, const Place& from, const LineMove& move,
                             std::uint32_t least_chords = 1) {
  LevelledLine line;
  line.begin(mesh, from, move, least_chords);
  std::vector<Place> ends;
  while (!line.done()) {
    const LineMove chord = line.next(mesh);
    EXPECT_EQ(chord.feedrate, move.feedrate);
    EXPECT_EQ(chord.stop_mask, move.stop_mask);
    ends.push_back(chord.target);
  }
  return ends;
}

// How far the chords leave the surface, at 17 places of each.
double deviation(const Surface& surface, const BedMesh& mesh, const Place& from,
                 const LineMove& move, const std::vector<Place>& chords) {
  Place begin = from;
  begin[2] += mesh.correction(from);
  double worst = 0;
  double way[4];
  for (std::size_t axis = 0; axis < 4; ++axis) way[axis] = to_mm(move.target[axis] - from[axis]);
  std::size_t longest = 3;
  for (const std::size_t axis : {0UZ, 1UZ}) {
    if (std::abs(way[axis]) > std::abs(way[longest])) longest = axis;
  }
  for (const Place& end : chords) {
    for (int i = 0; i <= 16; ++i) {
      double at[4];
      for (std::size_t axis = 0; axis < 4; ++axis) {
        at[axis] = to_mm(begin[axis]) + (to_mm(end[axis]) - to_mm(begin[axis])) * i / 16;
      }
      const double part = (at[longest] - to_mm(from[longest])) / way[longest];
      const double line_z = to_mm(from[2]) + way[2] * part;
      EXPECT_NEAR(at[0], to_mm(from[0]) + way[0] * part, 8 * nm);
      EXPECT_NEAR(at[1], to_mm(from[1]) + way[1] * part, 8 * nm);
      worst = std::max(worst, std::abs(at[2] - line_z - surface.correction(at[0], at[1], line_z)));
    }
    begin = end;
  }
  return worst;
}

TEST(levelled_line, stays_on_the_surface) {
  Random random(3);
  double worst = 0;
  std::size_t lines = 0, chords = 0;
  for (int meshes = 0; meshes < 200; ++meshes) {
    const Surface surface = random.surface();
    const BedMesh mesh = mesh_of(surface);
    Place from = random.place();
    for (int moves = 0; moves < 20; ++moves) {
      LineMove move{.target = random.place(),
                    .feedrate = units::MicrometersPerSecond(40'000),
                    .stop_mask = 4};
      // Most lines of a print lie in a layer; some begin or end on the grid, or go along one axis.
      if (random.below(2) == 0) move.target[2] = from[2];
      if (random.below(8) == 0) move.target[0] = mesh.line(0, random.below(mesh.points(0)));
      if (random.below(8) == 0) move.target[1] = from[1];
      const auto ends = chords_of(mesh, from, move);
      ASSERT_FALSE(ends.empty());
      Place last = move.target;
      last[2] += mesh.correction(move.target);
      ASSERT_EQ(ends.back(), last);
      const double off = deviation(surface, mesh, from, move, ends);
      ASSERT_LT(off, most_deviation) << "mesh " << meshes << " move " << moves;
      worst = std::max(worst, off);
      ++lines;
      chords += ends.size();
      from = move.target;
    }
  }
  std::printf("at most %.2f um off, %.1f chords a line\n", worst / um,
              static_cast<double>(chords) / static_cast<double>(lines));
}

// Every axis goes on as it would without: an extruder neither stops nor runs back.
TEST(levelled_line, shares_out_the_filament_evenly) {
  Random random(4);
  for (int meshes = 0; meshes < 50; ++meshes) {
    const BedMesh mesh = mesh_of(random.surface());
    const Place from = random.place();
    const LineMove move{.target = random.place(), .feedrate = units::MicrometersPerSecond(1)};
    for (const Place& end : chords_of(mesh, from, move)) {
      const double part = to_mm(end[0] - from[0]) / to_mm(move.target[0] - from[0]);
      ASSERT_NEAR(to_mm(end[3] - from[3]), to_mm(move.target[3] - from[3]) * part, 0.1 * um);
    }
  }
}

TEST(levelled_line, is_one_chord_where_nothing_bends_it) {
  Surface flat{.first = {0, 0}, .last = {100, 100}, .points = {2, 2}, .heights = {1, 1, 1, 1}};
  const BedMesh mesh = mesh_of(flat);
  const Place from{from_mm(10), from_mm(10), from_mm(0.2), from_mm(0)};
  LineMove move{.target = from, .feedrate = units::MicrometersPerSecond(1)};
  EXPECT_EQ(chords_of(mesh, from, move).size(), 1u);  // goes nowhere
  move.target[3] = from_mm(3);
  EXPECT_EQ(chords_of(mesh, from, move).size(), 1u);
  move.target[0] = from_mm(90);
  EXPECT_EQ(chords_of(mesh, from, move).size(), 1u);
  EXPECT_GE(chords_of(mesh, from, move, 5).size(), 5u);  // of a mechanism that needs them
}

TEST(levelled_line, refuses_what_its_arithmetic_cannot_hold) {
  Place from{};
  Place to{from_mm(2147), {}, {}, {}};
  EXPECT_TRUE(LevelledLine::can_be(from, to));
  to[0] = from_mm(-2148);
  EXPECT_FALSE(LevelledLine::can_be(from, to));
  from[0] = from_mm(-2000);
  EXPECT_TRUE(LevelledLine::can_be(from, to));
}

}  // namespace
