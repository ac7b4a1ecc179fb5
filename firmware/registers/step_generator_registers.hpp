// SPDX-License-Identifier: Apache-2.0
// Registers of `step_generator`. Generated from rtl/motion/step_generator.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// Queue of segments, tick rate, step pulses of all axes, positions and stops.
namespace registers::step_generator {

inline constexpr std::uint32_t base = 0xF0003000u;

// What this build of the step generator has.
struct Build {
  static constexpr std::uint32_t address = base + 0x0u;
  static constexpr unsigned axes_low = 0, axes_width = 4;
  static constexpr std::uint32_t axes_max = 0xFu, axes_mask = axes_max << axes_low;
  static constexpr unsigned queue_depth_low = 8, queue_depth_width = 16;
  static constexpr std::uint32_t queue_depth_max = 0xFFFFu, queue_depth_mask = queue_depth_max << queue_depth_low;
  // Number of axes.
  std::uint32_t axes{};
  // Segments that fit into the queue (the one being executed is not in the queue).
  std::uint32_t queue_depth{};

  [[gnu::always_inline]] static constexpr Build decode([[maybe_unused]] std::uint32_t word) {
    return {
      .axes = (word & 0xFu),
      .queue_depth = ((word >> 8u) & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (axes & 0xFu) |
           (queue_depth & 0xFFFFu) << 8u;
  }
};

// What software permits.
struct Control {
  static constexpr std::uint32_t address = base + 0x4u;
  static constexpr unsigned run_bit = 0;
  static constexpr std::uint32_t run_mask = 1u << run_bit;
  static constexpr unsigned queue_interrupt_enable_bit = 1;
  static constexpr std::uint32_t queue_interrupt_enable_mask = 1u << queue_interrupt_enable_bit;
  static constexpr unsigned stop_interrupt_enable_bit = 2;
  static constexpr std::uint32_t stop_interrupt_enable_mask = 1u << stop_interrupt_enable_bit;
  static constexpr unsigned queue_threshold_low = 16, queue_threshold_width = 16;
  static constexpr std::uint32_t queue_threshold_max = 0xFFFFu, queue_threshold_mask = queue_threshold_max << queue_threshold_low;
  // Motion may start from rest. Clearing it does not interrupt motion.
  bool run{};
  // Interrupt while the queue holds at most queue_threshold segments.
  bool queue_interrupt_enable{};
  // Interrupt while a stop waits for its acknowledgement.
  bool stop_interrupt_enable{};
  // Level of the queue at and below which it requests more.
  std::uint32_t queue_threshold{};

  [[gnu::always_inline]] static constexpr Control decode([[maybe_unused]] std::uint32_t word) {
    return {
      .run = (word & 0x1u) != 0,
      .queue_interrupt_enable = ((word >> 1u) & 0x1u) != 0,
      .stop_interrupt_enable = ((word >> 2u) & 0x1u) != 0,
      .queue_threshold = ((word >> 16u) & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (run ? 1u : 0u) |
           (queue_interrupt_enable ? 1u : 0u) << 1u |
           (stop_interrupt_enable ? 1u : 0u) << 2u |
           (queue_threshold & 0xFFFFu) << 16u;
  }
};

// Each bit written as 1 does one thing at once.
struct Command {
  static constexpr std::uint32_t address = base + 0x8u;
  static constexpr unsigned flush_bit = 0;
  static constexpr std::uint32_t flush_mask = 1u << flush_bit;
  static constexpr unsigned stop_bit = 1;
  static constexpr std::uint32_t stop_mask = 1u << stop_bit;
  static constexpr unsigned acknowledge_stop_bit = 2;
  static constexpr std::uint32_t acknowledge_stop_mask = 1u << acknowledge_stop_bit;
  static constexpr unsigned snapshot_bit = 3;
  static constexpr std::uint32_t snapshot_mask = 1u << snapshot_bit;
  static constexpr unsigned clear_errors_bit = 4;
  static constexpr std::uint32_t clear_errors_mask = 1u << clear_errors_bit;
  static constexpr unsigned start_bit = 5;
  static constexpr std::uint32_t start_mask = 1u << start_bit;
  static constexpr unsigned brake_bit = 6;
  static constexpr std::uint32_t brake_mask = 1u << brake_bit;
  static constexpr unsigned feed_watchdog_bit = 7;
  static constexpr std::uint32_t feed_watchdog_mask = 1u << feed_watchdog_bit;
  static constexpr unsigned positions_known_bit = 8;
  static constexpr std::uint32_t positions_known_mask = 1u << positions_known_bit;
  // Forget the queue and a segment being written; the one being executed is finished.
  bool flush{};
  // Software's emergency stop: no tick from this clock on, queue flushed.
  bool stop{};
  // Permit motion again after a stop; without effect while the emergency stop input is active, and together with stop or brake.
  bool acknowledge_stop{};
  // Latch the positions of all axes and the time of one clock.
  bool snapshot{};
  // Clear the register errors.
  bool clear_errors{};
  // Begin the segment that waits for its start; not remembered if none waits.
  bool start{};
  // Come to rest along the path by brake_slope, then stop as by `stop`. Any end stop of the segment then stops at once, but for the one that began the brake, until it is released.
  bool brake{};
  // Software is alive: the watchdog's time starts over.
  bool feed_watchdog{};
  // Clear status.positions_lost: software has found the axes again, or knows that it must.
  bool positions_known{};

  [[gnu::always_inline]] static constexpr Command decode([[maybe_unused]] std::uint32_t word) {
    return {
      .flush = (word & 0x1u) != 0,
      .stop = ((word >> 1u) & 0x1u) != 0,
      .acknowledge_stop = ((word >> 2u) & 0x1u) != 0,
      .snapshot = ((word >> 3u) & 0x1u) != 0,
      .clear_errors = ((word >> 4u) & 0x1u) != 0,
      .start = ((word >> 5u) & 0x1u) != 0,
      .brake = ((word >> 6u) & 0x1u) != 0,
      .feed_watchdog = ((word >> 7u) & 0x1u) != 0,
      .positions_known = ((word >> 8u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (flush ? 1u : 0u) |
           (stop ? 1u : 0u) << 1u |
           (acknowledge_stop ? 1u : 0u) << 2u |
           (snapshot ? 1u : 0u) << 3u |
           (clear_errors ? 1u : 0u) << 4u |
           (start ? 1u : 0u) << 5u |
           (brake ? 1u : 0u) << 6u |
           (feed_watchdog ? 1u : 0u) << 7u |
           (positions_known ? 1u : 0u) << 8u;
  }
};

// What the step generator is doing.
struct Status {
  static constexpr std::uint32_t address = base + 0xCu;
  static constexpr unsigned moving_bit = 0;
  static constexpr std::uint32_t moving_mask = 1u << moving_bit;
  static constexpr unsigned idle_bit = 1;
  static constexpr std::uint32_t idle_mask = 1u << idle_bit;
  static constexpr unsigned stopped_bit = 2;
  static constexpr std::uint32_t stopped_mask = 1u << stopped_bit;
  static constexpr unsigned held_bit = 3;
  static constexpr std::uint32_t held_mask = 1u << held_bit;
  static constexpr unsigned braking_bit = 4;
  static constexpr std::uint32_t braking_mask = 1u << braking_bit;
  static constexpr unsigned waiting_bit = 5;
  static constexpr std::uint32_t waiting_mask = 1u << waiting_bit;
  static constexpr unsigned positions_lost_bit = 6;
  static constexpr std::uint32_t positions_lost_mask = 1u << positions_lost_bit;
  static constexpr unsigned level_low = 8, level_width = 8;
  static constexpr std::uint32_t level_max = 0xFFu, level_mask = level_max << level_low;
  static constexpr unsigned free_low = 16, free_width = 8;
  static constexpr std::uint32_t free_max = 0xFFu, free_mask = free_max << free_low;
  // A segment is being executed.
  bool moving{};
  // No segment is executed or queued, every pulse is finished, and all guard times are over.
  bool idle{};
  // A stop waits for its acknowledgement.
  bool stopped{};
  // A segment is being executed, but the scale of time has come to 0.
  bool held{};
  // A stop has been requested; motion comes to rest along brake_slope.
  bool braking{};
  // At rest, with a next segment that waits for its start.
  bool waiting{};
  // The emergency stop has taken the motors' current: they need not stand where their positions say. Until the command positions_known.
  bool positions_lost{};
  // Segments in the queue.
  std::uint32_t level{};
  // Segments that can still be written.
  std::uint32_t free{};

  [[gnu::always_inline]] static constexpr Status decode([[maybe_unused]] std::uint32_t word) {
    return {
      .moving = (word & 0x1u) != 0,
      .idle = ((word >> 1u) & 0x1u) != 0,
      .stopped = ((word >> 2u) & 0x1u) != 0,
      .held = ((word >> 3u) & 0x1u) != 0,
      .braking = ((word >> 4u) & 0x1u) != 0,
      .waiting = ((word >> 5u) & 0x1u) != 0,
      .positions_lost = ((word >> 6u) & 0x1u) != 0,
      .level = ((word >> 8u) & 0xFFu),
      .free = ((word >> 16u) & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (moving ? 1u : 0u) |
           (idle ? 1u : 0u) << 1u |
           (stopped ? 1u : 0u) << 2u |
           (held ? 1u : 0u) << 3u |
           (braking ? 1u : 0u) << 4u |
           (waiting ? 1u : 0u) << 5u |
           (positions_lost ? 1u : 0u) << 6u |
           (level & 0xFFu) << 8u |
           (free & 0xFFu) << 16u;
  }
};

// What was refused since the last clear_errors.
struct Errors {
  static constexpr std::uint32_t address = base + 0x10u;
  static constexpr unsigned queue_full_bit = 0;
  static constexpr std::uint32_t queue_full_mask = 1u << queue_full_bit;
  static constexpr unsigned incomplete_bit = 1;
  static constexpr std::uint32_t incomplete_mask = 1u << incomplete_bit;
  static constexpr unsigned illegal_bit = 2;
  static constexpr std::uint32_t illegal_mask = 1u << illegal_bit;
  static constexpr unsigned while_stopped_bit = 3;
  static constexpr std::uint32_t while_stopped_mask = 1u << while_stopped_bit;
  static constexpr unsigned position_bit = 4;
  static constexpr std::uint32_t position_mask = 1u << position_bit;
  static constexpr unsigned settings_bit = 5;
  static constexpr std::uint32_t settings_mask = 1u << settings_bit;
  static constexpr unsigned disabled_bit = 6;
  static constexpr std::uint32_t disabled_mask = 1u << disabled_bit;
  // A segment was committed to a full queue.
  bool queue_full{};
  // A segment was committed of which not every word was written.
  bool incomplete{};
  // A segment was committed that cannot be executed: a number out of range, or an axis ahead and behind.
  bool illegal{};
  // A segment was committed from the clock on in which a stop or brake was requested, before it was acknowledged.
  bool while_stopped{};
  // A position was written while the step generator was not idle.
  bool position{};
  // Refused: pulse_guard, direction_guard or rate_floor while not idle; both_edges of a step pin that is high; a rate_floor of 0; a motor switched off while a segment is executed or queued, or on before an emergency stop was acknowledged.
  bool settings{};
  // A segment was committed with steps of an axis whose motor is off.
  bool disabled{};

  [[gnu::always_inline]] static constexpr Errors decode([[maybe_unused]] std::uint32_t word) {
    return {
      .queue_full = (word & 0x1u) != 0,
      .incomplete = ((word >> 1u) & 0x1u) != 0,
      .illegal = ((word >> 2u) & 0x1u) != 0,
      .while_stopped = ((word >> 3u) & 0x1u) != 0,
      .position = ((word >> 4u) & 0x1u) != 0,
      .settings = ((word >> 5u) & 0x1u) != 0,
      .disabled = ((word >> 6u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (queue_full ? 1u : 0u) |
           (incomplete ? 1u : 0u) << 1u |
           (illegal ? 1u : 0u) << 2u |
           (while_stopped ? 1u : 0u) << 3u |
           (position ? 1u : 0u) << 4u |
           (settings ? 1u : 0u) << 5u |
           (disabled ? 1u : 0u) << 6u;
  }
};

// Enable pins of the motor drivers. Switched off only while no segment is executed or queued; the emergency stop input switches all off at once, and they stay so until the stop is acknowledged and this is written again.
struct MotorEnable {
  static constexpr std::uint32_t address = base + 0x14u;
  static constexpr unsigned axes_low = 0, axes_width = 8;
  static constexpr std::uint32_t axes_max = 0xFFu, axes_mask = axes_max << axes_low;
  // 1 = driver enabled; bit = axis.
  std::uint32_t axes{};

  [[gnu::always_inline]] static constexpr MotorEnable decode([[maybe_unused]] std::uint32_t word) {
    return {
      .axes = (word & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (axes & 0xFFu);
  }
};

// The tick rate is never integrated below this. Written only when idle, and never 0.
struct RateFloor {
  static constexpr std::uint32_t address = base + 0x18u;
  static constexpr unsigned rate_low = 0, rate_width = 31;
  static constexpr std::uint32_t rate_max = 0x7FFFFFFFu, rate_mask = rate_max << rate_low;
  // In 2^-32 ticks per clock; 8590 after reset, 100 ticks/s at 50 MHz.
  std::uint32_t rate{};

  [[gnu::always_inline]] static constexpr RateFloor decode([[maybe_unused]] std::uint32_t word) {
    return {
      .rate = (word & 0x7FFFFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (rate & 0x7FFFFFFFu);
  }
};

// The scale of time that is aimed at while segments are executed; the path stays.
struct Override {
  static constexpr std::uint32_t address = base + 0x1Cu;
  static constexpr unsigned scale_low = 0, scale_width = 18;
  static constexpr std::uint32_t scale_max = 0x3FFFFu, scale_mask = scale_max << scale_low;
  // In 2^-16: 65536 = as segments ask, 0 = feed hold, up to 4. From 7/64 tick per clock on at most 2, from 15/64 on at most 1.
  std::uint32_t scale{};

  [[gnu::always_inline]] static constexpr Override decode([[maybe_unused]] std::uint32_t word) {
    return {
      .scale = (word & 0x3FFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (scale & 0x3FFFFu);
  }
};

// How fast the scale changes while a segment is executed; at rest it changes at once.
struct OverrideSlope {
  static constexpr std::uint32_t address = base + 0x20u;
  static constexpr unsigned slope_low = 0, slope_width = 32;
  static constexpr std::uint32_t slope_max = 0xFFFFFFFFu, slope_mask = slope_max << slope_low;
  // In 2^-32 per clock; after reset from 1 to 0 in 50 ms at 50 MHz. At 0 the scale stays. Slower while it falls in a segment that decelerates, or rises in one that accelerates: by half below 1/2, to a quarter below 3/4, to an eighth below 7/8; from there on it waits.
  std::uint32_t slope{};

  [[gnu::always_inline]] static constexpr OverrideSlope decode([[maybe_unused]] std::uint32_t word) {
    return {
      .slope = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return slope;
  }
};

// How fast the scale falls to 0 in a stop by braking: a deceleration of tick rate times slope.
struct BrakeSlope {
  static constexpr std::uint32_t address = base + 0x24u;
  static constexpr unsigned slope_low = 0, slope_width = 32;
  static constexpr std::uint32_t slope_max = 0xFFFFFFFFu, slope_mask = slope_max << slope_low;
  // In 2^-32 per clock. At 0 what would brake stops at once.
  std::uint32_t slope{};

  [[gnu::always_inline]] static constexpr BrakeSlope decode([[maybe_unused]] std::uint32_t word) {
    return {
      .slope = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return slope;
  }
};

// The scale of time at this moment.
struct Scale {
  static constexpr std::uint32_t address = base + 0x28u;
  static constexpr unsigned scale_low = 0, scale_width = 18;
  static constexpr std::uint32_t scale_max = 0x3FFFFu, scale_mask = scale_max << scale_low;
  // In 2^-16, rounded down.
  std::uint32_t scale{};

  [[gnu::always_inline]] static constexpr Scale decode([[maybe_unused]] std::uint32_t word) {
    return {
      .scale = (word & 0x3FFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (scale & 0x3FFFFu);
  }
};

// Stops motion when software does not feed it.
struct Watchdog {
  static constexpr std::uint32_t address = base + 0x2Cu;
  static constexpr unsigned clocks_low = 0, clocks_width = 32;
  static constexpr std::uint32_t clocks_max = 0xFFFFFFFFu, clocks_mask = clocks_max << clocks_low;
  // Longest time of motion from one feed_watchdog to the next, in clocks; 0 = not watched, as after reset. A shorter one that is written in motion counts from then on.
  std::uint32_t clocks{};

  [[gnu::always_inline]] static constexpr Watchdog decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

// First word of a segment: begins a new one and forgets words written before.
struct SegmentFlags {
  static constexpr std::uint32_t address = base + 0x30u;
  static constexpr unsigned backward_low = 0, backward_width = 8;
  static constexpr std::uint32_t backward_max = 0xFFu, backward_mask = backward_max << backward_low;
  static constexpr unsigned continues_line_bit = 8;
  static constexpr std::uint32_t continues_line_mask = 1u << continues_line_bit;
  static constexpr unsigned ends_motion_bit = 9;
  static constexpr std::uint32_t ends_motion_mask = 1u << ends_motion_bit;
  static constexpr unsigned stop_on_change_bit = 10;
  static constexpr std::uint32_t stop_on_change_mask = 1u << stop_on_change_bit;
  static constexpr unsigned stop_on_release_bit = 11;
  static constexpr std::uint32_t stop_on_release_mask = 1u << stop_on_release_bit;
  static constexpr unsigned stop_brakes_bit = 12;
  static constexpr std::uint32_t stop_brakes_mask = 1u << stop_brakes_bit;
  static constexpr unsigned waits_for_start_bit = 13;
  static constexpr std::uint32_t waits_for_start_mask = 1u << waits_for_start_bit;
  static constexpr unsigned stop_mask_low = 16, stop_mask_width = 8;
  static constexpr std::uint32_t stop_mask_max = 0xFFu, stop_mask_mask = stop_mask_max << stop_mask_low;
  static constexpr unsigned ahead_low = 24, ahead_width = 4;
  static constexpr std::uint32_t ahead_max = 0xFu, ahead_mask = ahead_max << ahead_low;
  static constexpr unsigned behind_low = 28, behind_width = 4;
  static constexpr std::uint32_t behind_max = 0xFu, behind_mask = behind_max << behind_low;
  // Axes that move in negative direction; not used with continues_line.
  std::uint32_t backward{};
  // The line of the segment before goes on: line_ticks, steps, backward, ahead and behind stay.
  bool continues_line{};
  // Standing still after this segment is intended, not an underrun.
  bool ends_motion{};
  // The end stops of stop_mask count only if they become triggered during this segment.
  bool stop_on_change{};
  // The end stops of stop_mask count when released, not when triggered.
  bool stop_on_release{};
  // The end stops of stop_mask brake by brake_slope; otherwise, and where it brakes already, no tick is made from their clock on.
  bool stop_brakes{};
  // Begin from rest, and only at a rising edge of the start input or at the command start.
  bool waits_for_start{};
  // End stops that end all motion during this segment.
  std::uint32_t stop_mask{};
  // Axes 0..3 a quarter of a step early: their error terms start at line_ticks/2 + line_ticks/4.
  std::uint32_t ahead{};
  // Axes 0..3 a quarter of a step late: start at line_ticks/4, those of neither set at line_ticks/2.
  std::uint32_t behind{};

  [[gnu::always_inline]] static constexpr SegmentFlags decode([[maybe_unused]] std::uint32_t word) {
    return {
      .backward = (word & 0xFFu),
      .continues_line = ((word >> 8u) & 0x1u) != 0,
      .ends_motion = ((word >> 9u) & 0x1u) != 0,
      .stop_on_change = ((word >> 10u) & 0x1u) != 0,
      .stop_on_release = ((word >> 11u) & 0x1u) != 0,
      .stop_brakes = ((word >> 12u) & 0x1u) != 0,
      .waits_for_start = ((word >> 13u) & 0x1u) != 0,
      .stop_mask = ((word >> 16u) & 0xFFu),
      .ahead = ((word >> 24u) & 0xFu),
      .behind = ((word >> 28u) & 0xFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (backward & 0xFFu) |
           (continues_line ? 1u : 0u) << 8u |
           (ends_motion ? 1u : 0u) << 9u |
           (stop_on_change ? 1u : 0u) << 10u |
           (stop_on_release ? 1u : 0u) << 11u |
           (stop_brakes ? 1u : 0u) << 12u |
           (waits_for_start ? 1u : 0u) << 13u |
           (stop_mask & 0xFFu) << 16u |
           (ahead & 0xFu) << 24u |
           (behind & 0xFu) << 28u;
  }
};

// Ticks of the whole line, 1 .. 2^31 - 1; to be written before ticks and steps.
struct SegmentLineTicks {
  static constexpr std::uint32_t address = base + 0x34u;
  static constexpr unsigned ticks_low = 0, ticks_width = 32;
  static constexpr std::uint32_t ticks_max = 0xFFFFFFFFu, ticks_mask = ticks_max << ticks_low;
  // Ticks.
  std::uint32_t ticks{};

  [[gnu::always_inline]] static constexpr SegmentLineTicks decode([[maybe_unused]] std::uint32_t word) {
    return {
      .ticks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return ticks;
  }
};

// Ticks of this segment, 1 .. what is left of the line.
struct SegmentTicks {
  static constexpr std::uint32_t address = base + 0x38u;
  static constexpr unsigned ticks_low = 0, ticks_width = 32;
  static constexpr std::uint32_t ticks_max = 0xFFFFFFFFu, ticks_mask = ticks_max << ticks_low;
  // Ticks.
  std::uint32_t ticks{};

  [[gnu::always_inline]] static constexpr SegmentTicks decode([[maybe_unused]] std::uint32_t word) {
    return {
      .ticks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return ticks;
  }
};

// Low word: Tick rate at the start of the segment, at most 1/2 tick per clock.
struct SegmentRateLow {
  static constexpr std::uint32_t address = base + 0x3Cu;
  static constexpr unsigned rate_low = 0, rate_width = 32;
  static constexpr std::uint32_t rate_max = 0xFFFFFFFFu, rate_mask = rate_max << rate_low;
  // In 2^-64 ticks per clock. Bits 31:0.
  std::uint32_t rate{};

  [[gnu::always_inline]] static constexpr SegmentRateLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .rate = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return rate;
  }
};

// High word: Tick rate at the start of the segment, at most 1/2 tick per clock.
struct SegmentRateHigh {
  static constexpr std::uint32_t address = base + 0x40u;
  static constexpr unsigned rate_low = 0, rate_width = 32;
  static constexpr std::uint32_t rate_max = 0xFFFFFFFFu, rate_mask = rate_max << rate_low;
  // In 2^-64 ticks per clock. Bits 63:32.
  std::uint32_t rate{};

  [[gnu::always_inline]] static constexpr SegmentRateHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .rate = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return rate;
  }
};

// Low word: Change of the rate per clock.
struct SegmentAccelerationLow {
  static constexpr std::uint32_t address = base + 0x44u;
  static constexpr unsigned acceleration_low = 0, acceleration_width = 32;
  static constexpr std::uint32_t acceleration_max = 0xFFFFFFFFu, acceleration_mask = acceleration_max << acceleration_low;
  // In 2^-84 ticks per clock^2, signed. Bits 31:0.
  std::uint32_t acceleration{};

  [[gnu::always_inline]] static constexpr SegmentAccelerationLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .acceleration = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return acceleration;
  }
};

// High word: Change of the rate per clock.
struct SegmentAccelerationHigh {
  static constexpr std::uint32_t address = base + 0x48u;
  static constexpr unsigned acceleration_low = 0, acceleration_width = 32;
  static constexpr std::uint32_t acceleration_max = 0xFFFFFFFFu, acceleration_mask = acceleration_max << acceleration_low;
  // In 2^-84 ticks per clock^2, signed. Bits 63:32.
  std::uint32_t acceleration{};

  [[gnu::always_inline]] static constexpr SegmentAccelerationHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .acceleration = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return acceleration;
  }
};

// Low word: Change of the acceleration per clock. The acceleration stays where the change would take it out of its 64 bits.
struct SegmentJerkLow {
  static constexpr std::uint32_t address = base + 0x4Cu;
  static constexpr unsigned jerk_low = 0, jerk_width = 32;
  static constexpr std::uint32_t jerk_max = 0xFFFFFFFFu, jerk_mask = jerk_max << jerk_low;
  // In 2^-84 ticks per clock^3, signed. Bits 31:0.
  std::uint32_t jerk{};

  [[gnu::always_inline]] static constexpr SegmentJerkLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .jerk = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return jerk;
  }
};

// High word: Change of the acceleration per clock. The acceleration stays where the change would take it out of its 64 bits.
struct SegmentJerkHigh {
  static constexpr std::uint32_t address = base + 0x50u;
  static constexpr unsigned jerk_low = 0, jerk_width = 32;
  static constexpr std::uint32_t jerk_max = 0xFFFFFFFFu, jerk_mask = jerk_max << jerk_low;
  // In 2^-84 ticks per clock^3, signed. Bits 63:32.
  std::uint32_t jerk{};

  [[gnu::always_inline]] static constexpr SegmentJerkHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .jerk = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return jerk;
  }
};

// Steps of each axis in the whole line, without sign, 0 .. line_ticks.
struct SegmentSteps {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x54u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned steps_low = 0, steps_width = 32;
  static constexpr std::uint32_t steps_max = 0xFFFFFFFFu, steps_mask = steps_max << steps_low;
  // Steps.
  std::uint32_t steps{};

  [[gnu::always_inline]] static constexpr SegmentSteps decode([[maybe_unused]] std::uint32_t word) {
    return {
      .steps = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return steps;
  }
};

// Any write appends the segment to the queue, or refuses it and says why in errors.
struct SegmentCommit {
  static constexpr std::uint32_t address = base + 0x74u;
  static constexpr unsigned any_low = 0, any_width = 32;
  static constexpr std::uint32_t any_max = 0xFFFFFFFFu, any_mask = any_max << any_low;
  // Not used.
  std::uint32_t any{};

  [[gnu::always_inline]] static constexpr SegmentCommit decode([[maybe_unused]] std::uint32_t word) {
    return {
      .any = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return any;
  }
};

// Width of the step pulse and of the pause after it, per axis. Written only when idle.
struct PulseGuard {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x78u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned high_low = 0, high_width = 12;
  static constexpr std::uint32_t high_max = 0xFFFu, high_mask = high_max << high_low;
  static constexpr unsigned low_low = 16, low_width = 12;
  static constexpr std::uint32_t low_max = 0xFFFu, low_mask = low_max << low_low;
  static constexpr unsigned both_edges_bit = 31;
  static constexpr std::uint32_t both_edges_mask = 1u << both_edges_bit;
  // Clocks that step stays high; 0 counts as 1. 50 after reset.
  std::uint32_t high{};
  // Least clocks that step stays low; 0 counts as 1. 50 after reset.
  std::uint32_t low{};
  // The falling edge is a step too, for drivers set to that: high and low are then least times. Changed only while the step pin is low.
  bool both_edges{};

  [[gnu::always_inline]] static constexpr PulseGuard decode([[maybe_unused]] std::uint32_t word) {
    return {
      .high = (word & 0xFFFu),
      .low = ((word >> 16u) & 0xFFFu),
      .both_edges = ((word >> 31u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (high & 0xFFFu) |
           (low & 0xFFFu) << 16u |
           (both_edges ? 1u : 0u) << 31u;
  }
};

// Distance between a change of direction and the steps, per axis. Written only when idle.
struct DirectionGuard {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x98u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned setup_low = 0, setup_width = 12;
  static constexpr std::uint32_t setup_max = 0xFFFu, setup_mask = setup_max << setup_low;
  static constexpr unsigned hold_low = 16, hold_width = 12;
  static constexpr std::uint32_t hold_max = 0xFFFu, hold_mask = hold_max << hold_low;
  // Least clocks from a change of direction to a step; 0 counts as 1. 10 after reset.
  std::uint32_t setup{};
  // Least clocks from a step to a change of direction; 0 counts as 1. 10 after reset.
  std::uint32_t hold{};

  [[gnu::always_inline]] static constexpr DirectionGuard decode([[maybe_unused]] std::uint32_t word) {
    return {
      .setup = (word & 0xFFFu),
      .hold = ((word >> 16u) & 0xFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (setup & 0xFFFu) |
           (hold & 0xFFFu) << 16u;
  }
};

// Steps given, forward less backward. Written only when idle, refused otherwise.
struct Position {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0xB8u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned steps_low = 0, steps_width = 32;
  static constexpr std::uint32_t steps_max = 0xFFFFFFFFu, steps_mask = steps_max << steps_low;
  // Steps.
  std::int32_t steps{};

  [[gnu::always_inline]] static constexpr Position decode([[maybe_unused]] std::uint32_t word) {
    return {
      .steps = static_cast<std::int32_t>(word),
    };
  }
  constexpr std::uint32_t encode() const {
    return static_cast<std::uint32_t>(steps);
  }
};

// Positions of all axes in the clock of the last snapshot.
struct SnapshotPosition {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0xD8u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned steps_low = 0, steps_width = 32;
  static constexpr std::uint32_t steps_max = 0xFFFFFFFFu, steps_mask = steps_max << steps_low;
  // Steps.
  std::int32_t steps{};

  [[gnu::always_inline]] static constexpr SnapshotPosition decode([[maybe_unused]] std::uint32_t word) {
    return {
      .steps = static_cast<std::int32_t>(word),
    };
  }
  constexpr std::uint32_t encode() const {
    return static_cast<std::uint32_t>(steps);
  }
};

// Low word: Time of the last snapshot.
struct SnapshotTimeLow {
  static constexpr std::uint32_t address = base + 0xF8u;
  static constexpr unsigned clocks_low = 0, clocks_width = 32;
  static constexpr std::uint32_t clocks_max = 0xFFFFFFFFu, clocks_mask = clocks_max << clocks_low;
  // Clocks since reset. Bits 31:0.
  std::uint32_t clocks{};

  [[gnu::always_inline]] static constexpr SnapshotTimeLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

// High word: Time of the last snapshot.
struct SnapshotTimeHigh {
  static constexpr std::uint32_t address = base + 0xFCu;
  static constexpr unsigned clocks_low = 0, clocks_width = 32;
  static constexpr std::uint32_t clocks_max = 0xFFFFFFFFu, clocks_mask = clocks_max << clocks_low;
  // Clocks since reset. Bits 63:32.
  std::uint32_t clocks{};

  [[gnu::always_inline]] static constexpr SnapshotTimeHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

// Why motion was stopped; valid while braking or stopped. What cuts braking short is added.
struct StopCause {
  static constexpr std::uint32_t address = base + 0x100u;
  static constexpr unsigned end_stops_low = 0, end_stops_width = 8;
  static constexpr std::uint32_t end_stops_max = 0xFFu, end_stops_mask = end_stops_max << end_stops_low;
  static constexpr unsigned emergency_input_bit = 8;
  static constexpr std::uint32_t emergency_input_mask = 1u << emergency_input_bit;
  static constexpr unsigned software_bit = 9;
  static constexpr std::uint32_t software_mask = 1u << software_bit;
  static constexpr unsigned watchdog_bit = 10;
  static constexpr std::uint32_t watchdog_mask = 1u << watchdog_bit;
  static constexpr unsigned software_brake_bit = 11;
  static constexpr std::uint32_t software_brake_mask = 1u << software_brake_bit;
  // End stops of the mask that were triggered.
  std::uint32_t end_stops{};
  // The emergency stop input was active.
  bool emergency_input{};
  // Software commanded the stop.
  bool software{};
  // The watchdog was not fed.
  bool watchdog{};
  // Software commanded the brake.
  bool software_brake{};

  [[gnu::always_inline]] static constexpr StopCause decode([[maybe_unused]] std::uint32_t word) {
    return {
      .end_stops = (word & 0xFFu),
      .emergency_input = ((word >> 8u) & 0x1u) != 0,
      .software = ((word >> 9u) & 0x1u) != 0,
      .watchdog = ((word >> 10u) & 0x1u) != 0,
      .software_brake = ((word >> 11u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (end_stops & 0xFFu) |
           (emergency_input ? 1u : 0u) << 8u |
           (software ? 1u : 0u) << 9u |
           (watchdog ? 1u : 0u) << 10u |
           (software_brake ? 1u : 0u) << 11u;
  }
};

// Positions of all axes when the last stop was requested, after the tick of the clock before.
struct StopPosition {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x104u + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned steps_low = 0, steps_width = 32;
  static constexpr std::uint32_t steps_max = 0xFFFFFFFFu, steps_mask = steps_max << steps_low;
  // Steps.
  std::int32_t steps{};

  [[gnu::always_inline]] static constexpr StopPosition decode([[maybe_unused]] std::uint32_t word) {
    return {
      .steps = static_cast<std::int32_t>(word),
    };
  }
  constexpr std::uint32_t encode() const {
    return static_cast<std::uint32_t>(steps);
  }
};

// Low word: Time at which the last stop was requested.
struct StopTimeLow {
  static constexpr std::uint32_t address = base + 0x124u;
  static constexpr unsigned clocks_low = 0, clocks_width = 32;
  static constexpr std::uint32_t clocks_max = 0xFFFFFFFFu, clocks_mask = clocks_max << clocks_low;
  // Clocks since reset. Bits 31:0.
  std::uint32_t clocks{};

  [[gnu::always_inline]] static constexpr StopTimeLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

// High word: Time at which the last stop was requested.
struct StopTimeHigh {
  static constexpr std::uint32_t address = base + 0x128u;
  static constexpr unsigned clocks_low = 0, clocks_width = 32;
  static constexpr std::uint32_t clocks_max = 0xFFFFFFFFu, clocks_mask = clocks_max << clocks_low;
  // Clocks since reset. Bits 63:32.
  std::uint32_t clocks{};

  [[gnu::always_inline]] static constexpr StopTimeHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

// Segments begun since reset.
struct SegmentsExecuted {
  static constexpr std::uint32_t address = base + 0x12Cu;
  static constexpr unsigned count_low = 0, count_width = 32;
  static constexpr std::uint32_t count_max = 0xFFFFFFFFu, count_mask = count_max << count_low;
  // Segments, modulo 2^32.
  std::uint32_t count{};

  [[gnu::always_inline]] static constexpr SegmentsExecuted decode([[maybe_unused]] std::uint32_t word) {
    return {
      .count = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return count;
  }
};

// Times that the queue was empty at the end of a segment without ends_motion.
struct Underruns {
  static constexpr std::uint32_t address = base + 0x130u;
  static constexpr unsigned count_low = 0, count_width = 32;
  static constexpr std::uint32_t count_max = 0xFFFFFFFFu, count_mask = count_max << count_low;
  // Underruns, modulo 2^32.
  std::uint32_t count{};

  [[gnu::always_inline]] static constexpr Underruns decode([[maybe_unused]] std::uint32_t word) {
    return {
      .count = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return count;
  }
};

// The fullest that the queue has been since reset.
struct MaxLevel {
  static constexpr std::uint32_t address = base + 0x134u;
  static constexpr unsigned segments_low = 0, segments_width = 16;
  static constexpr std::uint32_t segments_max = 0xFFFFu, segments_mask = segments_max << segments_low;
  // Segments.
  std::uint32_t segments{};

  [[gnu::always_inline]] static constexpr MaxLevel decode([[maybe_unused]] std::uint32_t word) {
    return {
      .segments = (word & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (segments & 0xFFFFu);
  }
};

// Clocks by which the guards of all axes have delayed the common base.
struct Stalls {
  static constexpr std::uint32_t address = base + 0x138u;
  static constexpr unsigned clocks_low = 0, clocks_width = 32;
  static constexpr std::uint32_t clocks_max = 0xFFFFFFFFu, clocks_mask = clocks_max << clocks_low;
  // Clocks, modulo 2^32.
  std::uint32_t clocks{};

  [[gnu::always_inline]] static constexpr Stalls decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

// Clocks in which the guard of an axis delayed the common base.
struct AxisStalls {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x13Cu + 4u * static_cast<std::uint32_t>(index);
  }
  static constexpr unsigned clocks_low = 0, clocks_width = 32;
  static constexpr std::uint32_t clocks_max = 0xFFFFFFFFu, clocks_mask = clocks_max << clocks_low;
  // Clocks, modulo 2^32.
  std::uint32_t clocks{};

  [[gnu::always_inline]] static constexpr AxisStalls decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

// Tick rate at the start of the segment, at most 1/2 tick per clock. Two words.
struct SegmentRate {
  using Low = SegmentRateLow;
  using High = SegmentRateHigh;
  std::uint64_t rate{};

  [[gnu::always_inline]] static constexpr SegmentRate decode(Low low, High high) {
    return {.rate = static_cast<std::uint64_t>(std::uint64_t{high.rate} << 32 | low.rate)};
  }
  constexpr Low low() const { return {.rate = static_cast<std::uint32_t>(rate)}; }
  constexpr High high() const {
    return {.rate = static_cast<std::uint32_t>(static_cast<std::uint64_t>(rate) >> 32)};
  }
};

// Change of the rate per clock. Two words.
struct SegmentAcceleration {
  using Low = SegmentAccelerationLow;
  using High = SegmentAccelerationHigh;
  std::int64_t acceleration{};

  [[gnu::always_inline]] static constexpr SegmentAcceleration decode(Low low, High high) {
    return {.acceleration = static_cast<std::int64_t>(std::uint64_t{high.acceleration} << 32 | low.acceleration)};
  }
  constexpr Low low() const { return {.acceleration = static_cast<std::uint32_t>(acceleration)}; }
  constexpr High high() const {
    return {.acceleration = static_cast<std::uint32_t>(static_cast<std::uint64_t>(acceleration) >> 32)};
  }
};

// Change of the acceleration per clock. The acceleration stays where the change would take it out of its 64 bits. Two words.
struct SegmentJerk {
  using Low = SegmentJerkLow;
  using High = SegmentJerkHigh;
  std::int64_t jerk{};

  [[gnu::always_inline]] static constexpr SegmentJerk decode(Low low, High high) {
    return {.jerk = static_cast<std::int64_t>(std::uint64_t{high.jerk} << 32 | low.jerk)};
  }
  constexpr Low low() const { return {.jerk = static_cast<std::uint32_t>(jerk)}; }
  constexpr High high() const {
    return {.jerk = static_cast<std::uint32_t>(static_cast<std::uint64_t>(jerk) >> 32)};
  }
};

// Time of the last snapshot. Two words.
struct SnapshotTime {
  using Low = SnapshotTimeLow;
  using High = SnapshotTimeHigh;
  std::uint64_t clocks{};

  [[gnu::always_inline]] static constexpr SnapshotTime decode(Low low, High high) {
    return {.clocks = static_cast<std::uint64_t>(std::uint64_t{high.clocks} << 32 | low.clocks)};
  }
  constexpr Low low() const { return {.clocks = static_cast<std::uint32_t>(clocks)}; }
  constexpr High high() const {
    return {.clocks = static_cast<std::uint32_t>(static_cast<std::uint64_t>(clocks) >> 32)};
  }
};

// Time at which the last stop was requested. Two words.
struct StopTime {
  using Low = StopTimeLow;
  using High = StopTimeHigh;
  std::uint64_t clocks{};

  [[gnu::always_inline]] static constexpr StopTime decode(Low low, High high) {
    return {.clocks = static_cast<std::uint64_t>(std::uint64_t{high.clocks} << 32 | low.clocks)};
  }
  constexpr Low low() const { return {.clocks = static_cast<std::uint32_t>(clocks)}; }
  constexpr High high() const {
    return {.clocks = static_cast<std::uint32_t>(static_cast<std::uint64_t>(clocks) >> 32)};
  }
};

}  // namespace registers::step_generator
