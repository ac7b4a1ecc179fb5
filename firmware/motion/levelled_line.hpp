// SPDX-License-Identifier: Apache-2.0
// A straight line above an uneven bed, as chords whose ends have the right height.
#pragma once

#include <cstdint>
#include <span>

#include "motion/bed_mesh.hpp"
#include "motion/planner_move.hpp"

namespace motion {

// Parts of a line, in 2^-30.
using LinePart = std::uint32_t;
inline constexpr LinePart whole_line = 1u << 30;

// Where a line crosses lines of the grid that lie across an axis.
class Crossings {
 public:
  // The line goes by `distance` along the axis, below 2^31 nm.
  void begin(std::span<const units::Nanometers> lines, const units::Position& from,
             units::Nanometers distance);
  // The next one; the whole line where there is none before its end.
  LinePart next() const { return next_; }
  // Those up to here are behind.
  void pass(LinePart here);

 private:
  void find();

  std::span<const units::Nanometers> lines_;  // still to come
  units::Position from_{};
  units::Nanometers distance_{};
  LinePart next_{whole_line};
};

class LevelledLine {
 public:
  // Between its chords' ends the path leaves the one above the mesh by so much at most, besides
  // roundings of 5 nm.
  static constexpr units::Nanometers most_deviation{5'000};
  static constexpr units::Nanometers longest{0x7FFF'FFFF};  // along each axis

  // Whether no axis goes farther than `longest`.
  static bool can_be(const units::PerAxis<units::Position>& from,
                     const units::PerAxis<units::Position>& to);

  // `mesh` is complete, and stays as it is until the last chord. There are at least `least_chords`,
  // none of them longer than such a part of the line. Coordinates are without correction.
  void begin(const BedMesh& mesh, const units::PerAxis<units::Position>& from, const LineMove& move,
             std::uint32_t least_chords);
  bool done() const { return here_ == whole_line; }
  // What is left is not to be made.
  void cancel() { here_ = whole_line; }

  // Motion starts when the last chord is there, without waiting for more.
  void flush() { flushes_ = !done(); }
  bool flushes() const { return flushes_; }

  // The next chord, corrected; the last one ends exactly at the target, corrected. Not if done().
  LineMove next(const BedMesh& mesh);

 private:
  units::PerAxis<units::Position> place(LinePart part) const;
  void begin_piece(const BedMesh& mesh);

  LineMove move_{};
  units::PerAxis<units::Position> from_{};
  units::PerAxis<std::int32_t> distance_{};  // nm
  std::uint32_t least_chords_{};
  Crossings across_x_, across_y_, across_z_;
  units::Nanometers height_{}, correction_{};  // at the start of the next piece
  LinePart here_{whole_line}, piece_end_{};
  std::uint32_t chords_left_{};  // of the piece
  bool flushes_{};
};

}  // namespace motion
