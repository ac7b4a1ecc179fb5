// SPDX-License-Identifier: Apache-2.0
// Makes the step pulses in the timer interrupt, from the same segments as the step generator.
#pragma once

#include <array>
#include <cstdint>

#include "motion/segment.hpp"
#include "software_stepping/block.hpp"
#include "software_stepping/interval.hpp"
#include "units/axes.hpp"

namespace software_stepping {

// In clocks; one for all axes, so the longest that any of them needs.
struct Guard {
  std::uint32_t high{1};
  std::uint32_t low{1};
  std::uint32_t direction_setup{1};
  std::uint32_t direction_hold{1};
};

// Words only: the simulation reads them from memory by the symbol software_stepping_counters.
struct Counters {
  std::uint32_t segments{};  // begun
  std::uint32_t underruns{};
  std::uint32_t max_level{};
  // Ticks that were behind by more than an interval, and the clocks by which they have delayed all
  // that followed.
  std::uint32_t late_ticks{};
  std::uint32_t delay_clocks{};
};

class Stepper {
 public:
  static constexpr std::uint64_t never = ~std::uint64_t{0};
  static constexpr std::uint32_t queue_depth = 5;
  using Positions = units::PerAxis<std::int32_t>;

  // `tick` and `counters` must outlive the stepper.
  explicit constexpr Stepper(Tick& tick, Counters& counters) : tick_(tick), counters_(counters) {}

  // For the program. The interrupt is masked where it would see inconsistent data.
  [[gnu::cold]] void configure(const Guard& guard, Interval longest_interval);
  // False where the queue is full, a stop waits for its acknowledgement, or the segment cannot be
  // executed: out of range, or what only the step generator can (jerk, stops but at once
  // and by level, a common start, lines of 2^23 ticks and more).
  [[gnu::noinline]] bool append(const motion::Segment& segment);
  [[gnu::cold]] void permit_motion(bool permitted);
  [[gnu::cold]] void flush();
  [[gnu::cold]] void stop();
  void acknowledge_stop() { stopped_ = false; }
  [[gnu::cold]] bool set_position(std::size_t axis, std::int32_t steps);
  // The timer interrupt comes at this time at the latest, besides those of the ticks.
  void set_alarm(std::uint64_t clocks);
  std::uint64_t alarm() const { return alarm_; }
  bool alarm_has_passed() const;

  bool moving() const { return moving_; }
  bool stopped() const { return stopped_; }
  std::uint8_t stop_cause() const { return stop_cause_; }  // end stops
  std::uint64_t stop_clock() const { return stop_clock_; }
  // Blocks, with the one that is executed.
  std::uint32_t level() const {
    return written_ - static_cast<volatile Tick&>(tick_).block->number;
  }
  std::uint32_t free() const { return queue_depth - level(); }
  [[gnu::cold]] Positions positions() const;
  const Counters& counters() const;

  // For the interrupt.
  void attend(Attention reason);

 private:
  static constexpr Interval shortest_careful_interval = too_long_interval;
  // Clocks in tick.S from the end of a pulse to the timer's deadline, less than what passes to the
  // next edge.
  static constexpr std::uint32_t clocks_to_edge = 4;

  static std::uint32_t directions_now();
  void link();
  void begin_segment();
  void begin_line();
  // False where none was due.
  bool make_tick_with_care();
  void raise();
  void fall();
  void end_segment();
  void go_on_after(Interval interval);
  void schedule();
  void set_timer();
  void pulse_is_over();
  void begin_motion();
  void come_to_rest(const Positions& positions);
  void stop(std::uint8_t end_stops);
  void keep(std::uint32_t blocks);
  void prepare(const motion::Segment& segment, Block& block);
  void prepare_line(const motion::Segment& segment, Block& block);
  Positions positions_now() const;

  Tick& tick_;
  Counters& counters_;
  std::array<Block, queue_depth> blocks_{};
  Block* to_write_{};  // null before configure()
  const Block* last_{};  // appended
  std::uint32_t written_{};
  Guard guard_;
  std::array<std::uint32_t, most_quick_followers + 1> pulse_delays_{};
  std::uint32_t hold_delay_{};
  Interval longest_interval_{};
  Interval interval_{};  // of a tick that is attended to
  std::uint32_t rose_{};  // clock of the last rising edge that was attended to
  std::uint64_t earliest_{};  // the guard permits no rising edge before
  std::uint64_t alarm_{never};
  bool alarm_rang_{};
  std::uint64_t stop_clock_{};
  Positions rest_{};  // where the axes stand
  Positions planned_{};  // where they will stand after all lines
  std::uint32_t unassigned_ticks_{};  // of the last appended line, in no segment yet
  std::uint32_t direction_{};
  std::uint8_t stop_cause_{};
  bool permitted_{};
  volatile bool moving_{};
  volatile bool stopped_{};
};

}  // namespace software_stepping
