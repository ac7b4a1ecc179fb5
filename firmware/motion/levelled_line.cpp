// SPDX-License-Identifier: Apache-2.0
// A line is cut where it crosses lines of the grid, and where fading begins and ends. Each piece is
// then a smooth curve, and is cut into equal chords.
#include "motion/levelled_line.hpp"

#include <algorithm>

#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"

namespace motion {
namespace {

using units::Nanometers;

constexpr int part_bits = 30;
constexpr std::size_t z = units::index_of(units::Axis::z);

// Of the middle from the chord between the ends.
Nanometers sag(Nanometers from, Nanometers middle, Nanometers to) {
  return Nanometers(
      static_cast<std::int64_t>(units::magnitude((from + to - middle * 2).count()) / 2));
}

}  // namespace

void Crossings::begin(std::span<const Nanometers> lines, const units::Position& from,
                      Nanometers distance) {
  lines_ = distance == Nanometers() ? std::span<const Nanometers>() : lines;
  from_ = from;
  distance_ = distance;
  find();
  pass(0);
}

void Crossings::pass(LinePart here) {
  units::LoopBound<BedMesh::most_points> passed;
  while (next_ <= here && next_ != whole_line) {
    passed.next();
    lines_ = distance_ < Nanometers() ? lines_.first(lines_.size() - 1) : lines_.subspan(1);
    find();
  }
}

void Crossings::find() {
  next_ = whole_line;
  if (lines_.empty()) return;
  const bool back = distance_ < Nanometers();
  const Nanometers line = back ? lines_.back() : lines_.front();
  const Nanometers to_line = back ? from_.nearest() - line : line - from_.nearest();
  const Nanometers all = back ? -distance_ : distance_;
  if (to_line >= all) return;
  next_ = to_line <= Nanometers()
              ? 0
              : static_cast<LinePart>((static_cast<std::uint64_t>(to_line.count()) << part_bits) /
                                      static_cast<std::uint64_t>(all.count()));
}

bool LevelledLine::can_be(const units::PerAxis<units::Position>& from,
                          const units::PerAxis<units::Position>& to) {
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const Nanometers distance = (to[i] - from[i]).nearest();
    if (distance > longest || -distance > longest) return false;
  }
  return true;
}

void LevelledLine::begin(const BedMesh& mesh, const units::PerAxis<units::Position>& from,
                         const LineMove& move, std::uint32_t least_chords) {
  from_ = from;
  move_ = move;
  least_chords_ = least_chords;
  flushes_ = false;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    distance_[i] = static_cast<std::int32_t>((move.target[i] - from[i]).nearest().count());
  }
  across_x_.begin(mesh.lines(0), from[0], Nanometers(distance_[0]));
  across_y_.begin(mesh.lines(1), from[1], Nanometers(distance_[1]));
  across_z_.begin(mesh.fade_lines(), from[z], Nanometers(distance_[z]));
  height_ = mesh.height_at(from);
  correction_ = mesh.faded(height_, from[z]);
  here_ = piece_end_ = 0;
  chords_left_ = 0;
}

units::PerAxis<units::Position> LevelledLine::place(LinePart part) const {
  if (part == whole_line) return move_.target;
  units::PerAxis<units::Position> result = from_;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    constexpr std::int64_t half = std::int64_t{1} << (part_bits - 1);
    result[i] += Nanometers((std::int64_t{distance_[i]} * part + half) >> part_bits);
  }
  return result;
}

// Within a piece the height is quadratic, and what fades of it linear: a cubic curve. Its chords
// leave it by less than the sag of the whole, with what its third power can add, divided by the
// square of their number.
void LevelledLine::begin_piece(const BedMesh& mesh) {
  across_x_.pass(here_);
  across_y_.pass(here_);
  across_z_.pass(here_);
  piece_end_ = std::min({across_x_.next(), across_y_.next(), across_z_.next()});
  const units::PerAxis<units::Position> middle = place(here_ + (piece_end_ - here_) / 2);
  const units::PerAxis<units::Position> end = place(piece_end_);
  const Nanometers middle_height = mesh.height_at(middle), end_height = mesh.height_at(end);
  const Nanometers end_correction = mesh.faded(end_height, end[z]);
  Nanometers deviation = sag(correction_, mesh.faded(middle_height, middle[z]), end_correction);
  if (distance_[z] != 0) deviation += sag(height_, middle_height, end_height) * 3 / 2;
  height_ = end_height;
  correction_ = end_correction;
  // Into 4096 chords at most, where 128 are enough for the steepest mesh.
  constexpr std::uint32_t most_halvings = 12;
  const std::uint64_t least = std::uint64_t{piece_end_ - here_} * least_chords_;
  std::uint32_t halvings = 0;
  units::LoopBound<most_halvings> bound;
  while (halvings < most_halvings &&
         (deviation > most_deviation * (std::int64_t{1} << 2 * halvings) ||
          least > std::uint64_t{whole_line} << halvings)) {
    bound.next();
    ++halvings;
  }
  chords_left_ = 1u << halvings;
}

LineMove LevelledLine::next(const BedMesh& mesh) {
  if (chords_left_ == 0) begin_piece(mesh);
  here_ += (piece_end_ - here_) / chords_left_;
  --chords_left_;
  LineMove chord = move_;
  chord.target = place(here_);
  chord.target[z] += mesh.correction(chord.target);
  return chord;
}

}  // namespace motion
