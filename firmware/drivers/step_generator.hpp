// SPDX-License-Identifier: Apache-2.0
// Driver of the step generator: hands over segments, reads positions, stops motion.
#pragma once

#include <cstddef>
#include <cstdint>

#include "drivers/guard_timings.hpp"
#include "machine/tools.hpp"
#include "motion/segment.hpp"
#include "units/axes.hpp"
#include "units/if_two_tools.hpp"

namespace drivers {

class StepGenerator {
 public:
  using Positions = units::PerAxis<std::int32_t>;  // in steps = pulses given, forward less backward

  struct Snapshot {
    Positions positions{};
    std::uint64_t clock{};  // clocks since reset
  };

  // Positions and time are those of the clock in which the stop was requested: after braking the
  // motors stand further on, where snapshot() says.
  struct Stop {
    bool stopped{};  // the rest is valid only if so or
    bool braking{};  // motion is coming to rest for it
    std::uint8_t end_stops{};
    bool emergency_input{};
    bool software{};
    bool watchdog{};
    bool software_brake{};
    Positions positions{};
    std::uint64_t clock{};
  };

  struct Counters {
    std::uint32_t segments{};  // begun
    std::uint32_t underruns{};  // queue empty at the end of a segment without ends_motion
    std::uint32_t stall_clocks{};  // by which the guards have delayed the common base
    units::PerAxis<std::uint32_t> axis_stall_clocks{};
    std::uint32_t max_level{};  // of the queue
  };

  // Sets every axis' guard and the rate floor (2^-32 ticks per clock, above 0 and below 1/2), and
  // permits motion. To be called once, when idle: the hardware refuses it in motion.
  void configure(const units::PerAxis<GuardTimings>& guards, std::uint32_t rate_floor);

  // The guard of the driver of a second extruder. As above; the hardware must have five axes.
  void configure_second_extruder(const GuardTimings& guard);
  // Which of the extruders E is from now on: its steps, its position, its motor. The other one
  // gets no step. To be called only when idle, so that no segment of the other waits. E's bit of
  // LineStart has no effect on the second one, whose lines begin in the middle of a step.
  void select_extruder(std::size_t extruder);

  std::uint32_t queue_depth() const;
  std::uint32_t free_segments() const;
  std::uint32_t queued_segments() const;

  // Appends a segment to the queue. False, and nothing done, if the queue is full, motion brakes, a
  // stop waits for its acknowledgement, the motor of an axis with steps is off, or the segment
  // cannot be executed (see motion/segment.hpp for the ranges). Motion starts at once when the
  // generator is at rest and motion is permitted.
  [[nodiscard]] bool append(const motion::Segment& segment);

  // Permits motion to start from rest, or only collects segments. Does not interrupt motion.
  void permit_motion(bool permitted);
  // Forgets the queue; the segment being executed is finished.
  void flush();

  // Whether what follows up to start() and the watchdog are there. Where software makes the steps
  // they are not: setting them has no effect.
  bool stretches_time() const;
  // How fast time passes for motion, its path unchanged: 65536 as segments ask, 0 for a feed
  // hold, below 4 * 65536. Approached by the slope while a segment is executed, taken at once at
  // rest. Above 65536 the tick rate limits it: from 7/64 tick per clock on to 2, from 15/64 on
  // to 1 times.
  void set_override(std::uint32_t scale_65536ths);
  void set_override_percent(std::uint32_t percent);
  // Slopes of the scale per clock, in 2^-32: of the override and of the brake. A slope takes a
  // tick rate r to 0 with a deceleration of r * slope. At 0 the scale stays as it is, and a
  // brake stops at once. Where the
  // segment itself accelerates to the same side the override gets less of its slope, none from 7/8
  // on, so that the sum of both exceeds neither; the brake does not wait.
  void set_slopes(std::uint32_t override_slope, std::uint32_t brake_slope);
  // The present scale, in 1/65536.
  std::uint32_t scale() const;
  // A feed hold has come to its end: a segment is executed, but nothing moves.
  bool held() const;

  // Begins a segment that waits for its start (as the start input does); not remembered
  // if none does.
  void start();
  // At rest, with a next segment that waits.
  bool waiting() const;

  // Motion stops if it goes on for so many clocks without feed_watchdog(); 0 = never. At rest only.
  void set_watchdog(std::uint32_t clocks);
  void feed_watchdog();

  bool moving() const;
  // Nothing executed, nothing queued, every pulse finished, and all guard times over.
  bool idle() const;

  // Positions of all axes at one instant.
  Snapshot snapshot();
  // Only when idle: false, and nothing done, otherwise.
  [[nodiscard]] bool set_position(units::Axis axis, std::int32_t steps);

  // Stops at once: no tick from now on, the queue is flushed. Lasts until acknowledge_stop().
  void stop();
  // Comes to rest along the path by the brake's slope, then as stop(). An end stop of the present
  // segment ends it at once, except the one that started it, until that is released.
  void brake();
  // The stop that waits for its acknowledgement, whether by end stop, input or software.
  Stop stop_state() const;
  // Whether there is one.
  bool stopped() const;
  // Permits motion again; without effect while the emergency stop input is active.
  void acknowledge_stop();

  // Switched off only while nothing is executed or queued, without effect otherwise. The emergency
  // stop input switches all off, until it has been acknowledged and they are enabled again.
  void enable_motor(units::Axis axis, bool enabled);
  bool motor_enabled(units::Axis axis) const;

  // Interrupt while at most `threshold` segments are queued.
  void enable_queue_interrupt(std::uint32_t threshold);
  void disable_queue_interrupt();
  // Interrupt while a stop waits for its acknowledgement.
  void enable_stop_interrupt(bool enabled);

  Counters counters() const;

 private:
  // Of the hardware, which numbers the extruders behind X, Y and Z.
  std::size_t hardware_axis(std::size_t axis) const {
    if constexpr (units::most_tools == 1) return axis;
    return axis == units::index_of(units::Axis::e) ? axis + extruder_[0] : axis;
  }

  std::size_t hardware_axes_ = units::axis_count;  // may be more than the firmware moves
  [[no_unique_address]] units::IfTwoTools<std::uint8_t> extruder_{};
};

}  // namespace drivers
