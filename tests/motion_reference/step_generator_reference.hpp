// SPDX-License-Identifier: Apache-2.0
// A model of the step generator by its specification, written independently of the VHDL,
// for comparison.
#pragma once

#include <deque>
#include <optional>

#include "tests/motion_reference/pace.hpp"
#include "tests/motion_reference/segment_draft.hpp"
#include "tests/motion_reference/stimulus.hpp"

namespace motion_reference {

// Where the VHDL counts down, this remembers when things happened; where the VHDL adds up an error
// term, this divides; where the VHDL works out a tick ahead, this does it when the tick comes.
class StepGeneratorReference {
 public:
  struct Guard {
    std::uint64_t high{50}, low{50}, setup{10}, hold{10};
    bool both_edges{};
  };
  using Positions = std::array<std::int32_t, axes>;
  struct Moment {
    Positions positions{};
    std::uint64_t clock{};
    bool operator==(const Moment&) const = default;
  };
  struct Counters {
    std::uint32_t segments{}, underruns{}, stalls{};
    std::array<std::uint32_t, axes> axis_stalls{};
    std::size_t max_level{};
    bool operator==(const Counters&) const = default;
  };

  // In the current clock; at most one write every second clock.
  void apply(const Stimulus& stimulus);
  // To the next clock.
  void clock();

  std::uint64_t now() const { return now_; }
  Pins pins() const;

  std::size_t level() const { return queue_.size(); }
  bool moving() const { return base_.has_value() || executing_; }
  bool idle() const;
  bool stopped() const { return stopped_; }
  bool waiting() const;
  std::uint64_t scale() const { return pace_.scale(); }
  std::uint32_t errors() const { return errors_; }
  std::uint32_t motors() const { return motors_; }
  bool positions_lost() const { return positions_lost_; }
  std::uint32_t stop_cause() const { return stop_cause_; }
  const Moment& stop_moment() const { return stop_moment_; }
  const Moment& snapshot() const { return snapshot_; }
  const Counters& counters() const { return counters_; }
  Positions positions() const;

 private:
  struct Write {
    std::uint32_t address{};
    std::uint32_t value{};
  };
  struct Axis {
    Guard guard{};
    std::uint64_t steps{};
    std::uint64_t first_error{};  // with which the line began
    bool wanted_backward{}, backward{};
    std::int32_t position{};
    bool high{};  // with both edges
    // First clocks in which the pins showed it.
    std::optional<std::uint64_t> stepped, turned;
  };
  struct Commands {
    bool flush, stop, brake, acknowledge_stop, snapshot, start, feed_watchdog, positions_known;
  };
  struct Queued {
    Segment segment;
    std::uint64_t ready;  // first clock in which it can be taken
  };
  // Of the base in the clock before, for queue and axes.
  struct Decision {
    bool tick{};
    std::optional<Segment> taken;
  };

  bool steps_at_next_tick(const Axis& axis) const;
  bool turns_in_next_clock(const Axis& axis) const;
  bool may_follow_a_tick(const Axis& axis) const;
  bool head_ready() const;
  Commands commands() const;
  std::uint32_t end_stops_hit() const;
  // First clock in which the axis may step again, by its last step.
  std::uint64_t free_again(const Axis& axis) const;
  // Whether the base comes to a tick, and whether all axes can follow; counts stalls.
  bool ticks();
  void turn_axes();
  void step_axes();
  void integrate(std::uint64_t leap);
  void take();
  void begin_segment(const Segment& segment);
  void obey(const Write& write);
  void commit();
  void set_position(std::size_t axis, std::uint32_t value);
  void set_rate_floor(std::uint32_t rate);
  void set_pulse_guard(Axis& axis, std::uint32_t value);
  void set_direction_guard(Axis& axis, std::uint32_t value);
  void switch_motors(std::uint32_t wanted);
  // What the emergency stop does to the motors, `stopped` before it.
  void cut_motors_off(bool stopped);
  // All steps of it have a driver.
  bool driven(const Segment& segment) const;
  void forget_queue();
  void begin_stop();
  void watch(bool moving, bool fed);

  std::uint64_t now_ = 0;
  std::optional<Write> pending_, current_;
  std::uint32_t inputs_ = 0, inputs_before_ = 0;

  std::array<Axis, axes> axis_{};
  std::uint64_t rate_floor_ = std::uint64_t{8590} << 32u;
  bool run_ = false;
  // Of the drivers, bit = axis.
  std::uint32_t motors_ = 0;
  // By an emergency that waits for its acknowledgement.
  bool motors_cut_ = false;
  bool positions_lost_ = false;

  SegmentDraft draft_;
  std::uint64_t line_left_ = 0;  // of the last committed line
  std::array<std::uint64_t, axes> line_steps_{};
  std::deque<Queued> queue_;
  bool queue_was_full_ = false;  // in the clock before, by which writes are judged
  std::uint64_t next_ready_ = 0;

  std::optional<Segment> base_;
  Decision decided_;
  // As the axes and stops see it.
  bool executing_ = false;
  Segment executed_{};
  std::uint64_t line_ticks_ = 1, line_ticks_done_ = 0, ticks_done_ = 0;
  std::uint64_t phase_ = 0, rate_ = 0, acceleration_ = 0, acceleration_before_ = 0;

  Pace pace_;
  bool braking_ = false, no_ramp_ = false;
  // End stops that began the brake, and are as they were then.
  std::uint32_t brakers_ = 0;
  bool refuses_segments_ = false;
  // Clocks of motion since software was last heard of, and how many of them are too many (0: none).
  std::uint64_t unheard_ = 0, watchdog_limit_ = 0;
  bool watchdog_expired_ = false;

  bool stopped_ = false, was_hit_ = false;
  std::uint32_t stop_cause_ = 0, errors_ = 0;
  Moment stop_moment_, snapshot_;
  Counters counters_;
};

}  // namespace motion_reference
