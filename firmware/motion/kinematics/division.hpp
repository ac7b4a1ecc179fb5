// SPDX-License-Identifier: Apache-2.0
// A line in equal chords, for kinematics whose motors do not follow a straight line by themselves.
#pragma once

#include <cstdint>

#include "motion/planner_move.hpp"
#include "motion/share.hpp"

namespace motion::kinematics {

class Division {
 public:
  // `chords` >= 1
  void begin(const units::PerAxis<units::Position>& from, const LineMove& move,
             std::uint32_t chords);
  bool done() const { return made_ == chords_; }
  std::uint32_t left() const { return chords_ - made_; }
  // What is left is not to be made.
  void cancel() { made_ = chords_; }

  // Motion starts when the last chord is there, without waiting for more.
  void flush() { flushes_ = !done(); }
  bool flushes() const { return flushes_; }

  // The next chord; the last one ends exactly at the target. Not if done().
  LineMove next();
  const units::PerAxis<units::Position>& target() const { return move_.target; }

 private:
  LineMove move_{};
  units::PerAxis<units::Position> from_{};
  units::PerAxis<Share> shares_{};  // nm
  std::uint32_t chords_{}, made_{};
  bool flushes_{};
};

// Where lines are straight: nothing to divide.
struct NoDivision {
  static void begin(const units::PerAxis<units::Position>&, const LineMove&, std::uint32_t) {}
  static constexpr bool done() { return true; }
  static constexpr std::uint32_t left() { return 0; }
  static void cancel() {}
  static LineMove next() { return {}; }
  static const units::PerAxis<units::Position>& target() { return nowhere; }
  static void flush() {}
  static constexpr bool flushes() { return false; }

 private:
  static constexpr units::PerAxis<units::Position> nowhere{};
};

}  // namespace motion::kinematics
