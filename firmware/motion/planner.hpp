// SPDX-License-Identifier: Apache-2.0
// From target positions to segments: keeps a ring of lines, finds the speeds at their junctions by
// look-ahead, and hands lines over to the step generator as late as is safe.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>

#include "machine/kinematics.hpp"
#include "motion/backlash.hpp"
#include "motion/fault.hpp"
#include "motion/limits.hpp"
#include "motion/line.hpp"
#include "motion/planner_move.hpp"
#include "motion/profile.hpp"
#include "motion/segment.hpp"
#include "motion/steps.hpp"
#include "motion/supply.hpp"
#include "units/axes.hpp"
#include "units/position.hpp"
#include "units/quantity.hpp"

namespace motion {

class Planner {
 public:
  static constexpr std::size_t capacity = 64;
  // Motion from rest waits until this much of it is planned, or for at most this long, or
  // for flush().
  static constexpr units::Microseconds start_delay{100'000};
  // Segments are handed over only while less than this is still to be executed, and less than what
  // is still in the ring, but for StepTiming::longest_pass: the rest stays plannable.
  static constexpr units::Microseconds horizon{40'000};
  // Look-ahead is done at the latest when so many lines have come since the last time.
  static constexpr std::size_t most_fresh = 16;

  Planner(const Limits& limits, const StepTiming& timing,
          const kinematics::Chosen& kinematics = kinematics::Chosen{});

  const kinematics::Chosen& kinematics() const { return kinematics_; }
  // M665: only while empty and at rest, and the position is to be set again afterwards.
  void set_kinematics(const kinematics::Chosen& kinematics) { kinematics_ = kinematics; }

  // Holds for lines appended from now on.
  void set_limits(const Limits& limits);
  const Limits& limits() const { return geometry_.limits(); }
  const StepTiming& timing() const { return timing_; }

  // The memory for what motors take up where they turn back; only with a motor for each axis.
  void set_backlash(Backlash* backlash) { backlash_ = backlash; }
  // Inlined for certain, so that link-time optimisation drops what depends on it.
  [[gnu::always_inline]] bool takes_up_backlash() const {
    return backlash_in_image && backlash_ != nullptr;
  }
  // Only where it does.
  Backlash& backlash() { return *backlash_; }
  const Backlash& backlash() const { return *backlash_; }

  bool has_room() const { return count_ < capacity; }
  // Nothing left to hand over (the step generator may still be busy).
  bool empty() const { return count_ == 0 && between_lines(); }
  // All segments of the line that was begun last have been handed over.
  bool between_lines() const { return next_phase_ == profile_.count; }
  // No ramp of third order has been handed over in part.
  bool between_halves() const { return !second_half_; }
  std::size_t lines() const { return count_; }
  // What has been handed over ends at rest.
  bool resting() const { return resting_; }
  // The time that what has been handed over lasts from now on.
  units::Microseconds in_hand(units::Microseconds now) const { return busy_until_ - now; }
  // Motion is to begin, from rest or behind what ends at rest.
  bool start_is_due(units::Microseconds now) const { return resting_ && may_hand_over(now); }

  // A fault leaves everything as it was. A move that steps no axis takes no room: its distance is
  // part of the next line. Targets are not checked against the travel: see check_bounds.
  // A line is not faster than the step generator can be fed, nor than lines come: see Supply.
  std::expected<void, Fault> append(const LineMove& move, units::Microseconds now);

  // Everything appended so far starts without waiting for more (M400, or before any wait for rest).
  void flush() { flush_ = true; }

  // The next segment, if one should be queued now. To be called while the step generator has room.
  std::optional<Segment> next_segment(units::Microseconds now);

  // Discards all lines after the step generator was stopped; the position must then be set.
  void clear();

  // The last target: relative moves go on from here.
  const units::PerAxis<units::Position>& position() const { return target_; }
  // The motors' in steps, rounded; what the step generator's counters show when all is done
  // (modulo 2^32), but for what they are ahead by backlash.
  const units::PerAxis<std::int64_t>& position_steps() const { return position_steps_; }

  // Where the motors are, to the nanometre.
  units::PerAxis<units::Position> motor_position() const;

  // Declares where the axes are; only while empty and at rest.
  void set_position(const units::PerAxis<units::Position>& position);
  void set_position_steps(const units::PerAxis<std::int64_t>& steps);
  // The same of E alone: another extruder, which is there.
  void set_extruder_position(const units::Position& position);

 private:
  bool moves_motor(std::size_t motor, const units::PerAxis<units::Position>& target) const;
  Line& line(std::size_t index) { return lines_[(first_ + index) % capacity]; }
  void append(const Displacement& displacement, const LineMove& move, units::Microseconds now);
  void look_ahead();
  Stock stock(units::Microseconds now) const;
  bool may_hand_over(units::Microseconds now) const;
  void hand_over_first(units::Microseconds now);
  bool set_half(const Phase& phase, Segment& segment);

  StepTiming timing_;
  Backlash* backlash_{};
  Geometry geometry_;
  [[no_unique_address]] kinematics::Chosen kinematics_;
  units::PerAxis<units::Position> target_{};  // of the last move
  units::PerAxis<units::Position> line_end_{};  // of the last move that had steps
  units::PerAxis<std::int64_t> position_steps_{};  // of both
  units::PerAxis<StepParts> residual_{};  // of line_end_ at position_steps_

  std::array<Line, capacity> lines_{};
  Course last_course_{};  // of the last appended line
  std::size_t first_{};
  std::size_t count_{};
  std::size_t fresh_{};  // of these, the last ones, which look-ahead has not seen
  std::size_t settled_{};  // lines before this index have entry speeds that look-ahead cannot raise
  Supply supply_;
  bool resting_{true};  // the last line handed over ends at rest
  bool flush_{};
  units::Microseconds waiting_since_{};
  units::Microseconds planned_time_{};  // at least, of all lines in the ring
  units::Microseconds busy_until_{};  // estimate, of what has been handed over

  // The line whose phases are being handed over.
  units::PerAxis<std::int32_t> steps_{};
  LineStart start_{};
  std::uint8_t stop_mask_{};
  bool second_half_{};  // is due of the next phase, a ramp of third order
  Profile profile_{};
  std::size_t next_phase_{};
};

}  // namespace motion
