// SPDX-License-Identifier: Apache-2.0
// Each end is calculated from the start, so that no error adds up.
#include "motion/kinematics/division.hpp"

namespace motion::kinematics {

void Division::begin(const units::PerAxis<units::Position>& from, const LineMove& move,
                     std::uint32_t chords) {
  from_ = from;
  move_ = move;
  chords_ = chords;
  made_ = 0;
  flushes_ = false;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    shares_[i] = Share((move.target[i] - from[i]).nearest().count(), chords);
  }
}

LineMove Division::next() {
  ++made_;
  if (done()) return move_;
  LineMove chord = move_;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    shares_[i].advance();
    chord.target[i] = from_[i] + units::Nanometers(shares_[i].covered());
  }
  return chord;
}

}  // namespace motion::kinematics
