// SPDX-License-Identifier: Apache-2.0
// Lines for motors that do not follow them by themselves: chord by chord, one in each pass.
#include <algorithm>

#include "application/motion_task.hpp"
#include "motion/kinematics/path_limits.hpp"

namespace application {

std::expected<void, motion::Fault> MotionTask::limit_to_mechanism(motion::LineMove& move) const {
  // Where the tool is says nothing before.
  if (kinematics().homes_motors() && homed_.empty()) {
    return std::unexpected(motion::Fault::not_homed);
  }
  const units::PerAxis<units::Position>& from = position();
  if (!kinematics().reaches(move.target) || !kinematics().straight_within(from, move.target)) {
    return std::unexpected(motion::Fault::target_out_of_reach);
  }
  auto acceleration = motion::max_acceleration;
  for (std::size_t i = 0; i < kinematics().curved_motors(); ++i) {
    acceleration = std::min(acceleration, limits().axes[i].max_acceleration);
  }
  move.feedrate =
      std::min({move.feedrate, motion::kinematics::speed_of_axes(limits(), from, move.target),
                kinematics().speed_limit(from, move.target, acceleration)});
  return {};
}

std::expected<void, motion::Fault> MotionTask::append_chords(motion::LineMove move) {
  if (const auto limited = limit_to_mechanism(move); !limited) return limited;
  const units::PerAxis<units::Position> from = position();
  chords_.begin(from, move, kinematics().chords(from, move.target));
  const auto accepted = append_line(chords_.next());
  if (!accepted) chords_.cancel();
  return accepted;
}

// All of them are within reach, and none is refused for want of room.
void MotionTask::go_on_with_chords() {
  if (!append_line(chords_.next())) chords_.cancel();
  if (chords_.done() && chords_.flushes()) planner_.flush();
}

}  // namespace application
