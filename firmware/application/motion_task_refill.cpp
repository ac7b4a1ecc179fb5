// SPDX-License-Identifier: Apache-2.0
// Segments to the step generator: the planner's lines, or the slots of shaped motion.
#include <algorithm>

#include "application/motion_task.hpp"
#include "motion/s_curve.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

// So much of the end of a shaped motion is handed over at a time, or what the longest pass needs.
constexpr units::Microseconds end_at_a_time{20'000};

}  // namespace

std::int32_t MotionTask::time_in_hand() const {
  // Nothing of a start moves before its lines are collected.
  const bool goes_on = !planner_.resting() && !collecting_;
  if (!goes_on || is_shaped() || step_generator_.stopped()) return no_haste;
  units::Microseconds in_hand = planner_.in_hand(pace_.time());
  if (queue_full_) in_hand = std::min(in_hand, queue_lasts_until_ - pace_.time());
  return static_cast<std::int32_t>(std::min<std::int64_t>(in_hand.count(), most_in_hand));
}

bool MotionTask::refill(units::Microseconds now) {
  bool more = true;
  pace_.update(now, step_generator_.moving());
  if (is_shaped()) {
    units::LoopBound<task_timing::shaped_slots> slots;
    for (unsigned i = 0; more && i < task_timing::shaped_slots; ++i) {
      slots.next();
      more = hand_over_line();
    }
    return more;
  }
  if (start_is_due()) begin_collecting();
  more = hand_over_line();
  if (collecting_ && (!more || planner_.in_hand(pace_.time()) >= longest_pass())) {
    collecting_ = false;
    step_generator_.permit_motion(true);
  }
  return more;
}

// Motion begins with what the longest pass needs, or with all that there is. What is under way ends
// at rest by itself.
void MotionTask::begin_collecting() {
  collecting_ = true;
  step_generator_.permit_motion(false);
}

bool MotionTask::hand_over_line() {
  queue_full_ = false;
  if (stopping_) return false;
  units::LoopBound<motion::most_phases> segments;  // of a line: it returns between lines
  units::EventBound<units::Event::line_begun, 1> begun;
  for (std::uint32_t free = step_generator_.free_segments(); free > 0; --free) {
    segments.next();
    const std::size_t lines = planner_.lines();
    const motion::Shaping::Output next = next_segment();
    if (planner_.lines() != lines) begin_line();
    if (!next.segment) return next.again;
    units::happens<units::Event::segment_made>(planner_.lines());
    // Refused only by a stop in this very moment; settle_stop() then voids the plan anyway.
    if (!step_generator_.append(*next.segment)) return false;
    if (next.again || planner_.between_lines()) return true;
    // A line with such ramps has more segments than the bound; it goes on at once.
    if (motion::s_curve_in_image && !planner_.between_halves()) return true;
  }
  queue_full_ = true;
  queue_lasts_until_ = pace_.time() + longest_pass();
  return false;
}

// The planner's, or what shaping makes of them.
motion::Shaping::Output MotionTask::next_segment() {
  const units::Microseconds time = pace_.time();
  if (!shapes() || !shaping_->active()) return {.segment = planner_.next_segment(time)};
  // The segment under way counts for nothing.
  const units::Microseconds queued = shaping_->slot_time() * step_generator_.queued_segments();
  return shaping_->next_segment(planner_, time,
                                queued >= std::max(end_at_a_time, planner_.timing().longest_pass));
}

void MotionTask::set_stretch(Stretch now, Stretch behind) {
  pace_.set_stretch(now);
  stretch_behind_.reset();
  if (behind == now) return;
  stretch_behind_ = behind;
  lines_before_ = planner_.lines() + chords_.left();
  if (levels()) levelling_->line_is_before_stretch = !levelling_->line.done();
}

// The first segment of a line goes to the step generator.
void MotionTask::begin_line() {
  if (!stretch_behind_ || lines_before_-- != 0) return;
  pace_.set_stretch(*stretch_behind_);
  stretch_behind_.reset();
}

}  // namespace application
