// SPDX-License-Identifier: Apache-2.0
// Makes the step pulses in the timer interrupt, from the same segments as the step generator.
#pragma once

#include <array>
#include <cstdint>

#include "motion/segment.hpp"
#include "software_stepping/interval.hpp"
#include "software_stepping/tick.hpp"
#include "units/axes.hpp"

namespace software_stepping {

// In clocks; one for all axes, so the longest that any of them needs.
struct Guard {
  std::uint32_t high{1};
  std::uint32_t low{1};
  std::uint32_t direction_setup{1};
  std::uint32_t direction_hold{1};
};

// A line and its segments, made ready for the interrupt by the program that appends them.
struct QueuedLine {
  std::array<Follower, units::axis_count + 1> followers{};
  std::uint32_t ticks{};
  units::PerAxis<std::int32_t> steps{};
  std::uint8_t leader{};  // pins that step at each tick
  std::uint8_t moving{};  // pins that step at all
  std::uint8_t backward{};
  motion::LineStart start{};
};

struct QueuedSegment {
  Interval first_interval{};
  Ramp ramp{};
  std::uint32_t ticks{};
  std::uint8_t stop_mask{};
  bool begins_line{};
  bool ends_motion{};
};

// A ring of which one side writes and the other, an interrupt apart, reads.
template <class Entry, std::uint32_t depth>
class Ring {
 public:
  Entry& to_write() { return entries_[written_ % depth]; }
  void write() { written_ = written_ + 1; }
  const Entry& to_read() const { return entries_[read_ % depth]; }
  Entry& to_read() { return entries_[read_ % depth]; }
  void free() { read_ = read_ + 1; }
  std::uint32_t level() const { return written_ - read_; }
  void keep(std::uint32_t entries) { written_ = read_ + entries; }

 private:
  static_assert((depth & (depth - 1)) == 0);
  std::array<Entry, depth> entries_{};
  volatile std::uint32_t written_{};
  volatile std::uint32_t read_{};
};

// Words only: the simulation reads them from memory by the symbol software_stepping_counters.
struct Counters {
  std::uint32_t segments{};  // begun
  std::uint32_t underruns{};
  std::uint32_t max_level{};
  // Ticks that were not made when the one after them was due already, and the clocks by which they
  // and the guard have delayed all that followed.
  std::uint32_t late_ticks{};
  std::uint32_t delay_clocks{};
};

class Stepper {
 public:
  static constexpr std::uint64_t never = ~std::uint64_t{0};
  static constexpr std::uint32_t queue_depth = 16;
  static constexpr std::uint32_t line_depth = 8;
  using Positions = units::PerAxis<std::int32_t>;

  // `counters` must outlive the stepper.
  explicit constexpr Stepper(Counters& counters) : counters_(counters) {}

  // For the program. The interrupt is kept out where it would see something half done.
  [[gnu::cold]] void configure(const Guard& guard, Interval longest_interval);
  // False where the queue is full, a stop waits for its acknowledgement, or the segment cannot be
  // executed: out of range, or what only the step generator can (jerk, stops but at once
  // and by level, a common start).
  [[gnu::cold]] bool append(const motion::Segment& segment);
  [[gnu::cold]] void permit_motion(bool permitted);
  [[gnu::cold]] void flush();
  [[gnu::cold]] void stop();
  void acknowledge_stop() { stopped_ = false; }
  [[gnu::cold]] bool set_position(std::size_t axis, std::int32_t steps);
  // The timer interrupt comes at this time at the latest, besides those of the ticks.
  void set_alarm(std::uint64_t clocks);

  bool alarm_has_passed() const;

  bool moving() const { return moving_; }
  bool stopped() const { return stopped_; }
  std::uint8_t stop_cause() const { return stop_cause_; }  // end stops
  std::uint64_t stop_clock() const { return stop_clock_; }
  std::uint32_t level() const { return segments_.level(); }
  // Segments that append() has room for, whether they begin lines or not.
  std::uint32_t free() const;
  [[gnu::cold]] Positions positions() const;
  const Counters& counters() const { return counters_; }

  // For the interrupt: what a tick needs each time, and the rest.
  Tick& tick() { return tick_; }
  void attend(Attention reason);

 private:
  // False where none was due.
  bool make_tick_with_care();
  void end_segment();
  void begin_segment();
  void begin_line();
  void end_line();
  void go_on_after(Interval interval);
  void schedule();
  void set_timer();
  void pulse_is_over();
  void begin_motion();
  void come_to_rest();
  void stop(std::uint8_t end_stops);
  std::uint32_t ticks_done() const;

  Tick tick_;
  Ring<QueuedSegment, queue_depth> segments_;  // from the one under way on, as the lines
  Ring<QueuedLine, line_depth> lines_;
  Counters& counters_;
  Guard guard_;
  Interval longest_interval_{};
  std::uint64_t earliest_{};  // the guard permits no rising edge before
  std::uint64_t alarm_{never};
  bool alarm_rang_{};
  std::uint64_t stop_clock_{};
  Positions line_start_{};
  std::uint32_t line_ticks_before_{};  // ticks of the line in segments that are over
  std::uint32_t unassigned_ticks_{};  // of the last appended line, in no segment yet
  std::uint8_t direction_{};
  std::uint8_t stop_cause_{};
  bool permitted_{};
  bool line_open_{};  // positions still follow the first of the lines
  volatile bool moving_{};
  volatile bool stopped_{};
};

}  // namespace software_stepping
