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
  // Number of axes.
  std::uint32_t axes{};
  // Segments that fit into the queue (the one being executed is not in the queue).
  std::uint32_t queue_depth{};

  static constexpr Build decode([[maybe_unused]] std::uint32_t word) {
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
  // Motion may start from rest. Clearing it does not interrupt motion.
  bool run{};
  // Interrupt while the queue holds at most queue_threshold segments.
  bool queue_interrupt_enable{};
  // Interrupt while a stop waits for its acknowledgement.
  bool stop_interrupt_enable{};
  // Level of the queue at and below which it asks for more.
  std::uint32_t queue_threshold{};

  static constexpr Control decode([[maybe_unused]] std::uint32_t word) {
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
  // Forget the queue and a segment being written; the one being executed is finished.
  bool flush{};
  // Software's emergency stop: no step after this clock, queue flushed.
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

  static constexpr Command decode([[maybe_unused]] std::uint32_t word) {
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
  // A segment is being executed.
  bool moving{};
  // No segment is executed or queued, every pulse is finished, and all guard times are over.
  bool idle{};
  // A stop waits for its acknowledgement.
  bool stopped{};
  // A segment is being executed, but the scale of time has come to 0.
  bool held{};
  // A stop has been asked for; motion comes to rest along brake_slope.
  bool braking{};
  // At rest, with a next segment that waits for its start.
  bool waiting{};
  // The emergency stop has taken the motors' current: they need not stand where their positions say. Until the command positions_known.
  bool positions_lost{};
  // Segments in the queue.
  std::uint32_t level{};
  // Segments that can still be written.
  std::uint32_t free{};

  static constexpr Status decode([[maybe_unused]] std::uint32_t word) {
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
  // A segment was committed to a full queue.
  bool queue_full{};
  // A segment was committed of which not every word was written.
  bool incomplete{};
  // A segment was committed that cannot be executed: a number out of range, or an axis ahead and behind.
  bool illegal{};
  // A segment was committed from the clock on in which a stop or brake was asked for, before it was acknowledged.
  bool while_stopped{};
  // A position was written while the step generator was not idle.
  bool position{};
  // Refused: pulse_guard, direction_guard or rate_floor while not idle; both_edges of a step pin that is high; a rate_floor of 0; a motor switched off while a segment is executed or queued, or on before an emergency stop was acknowledged.
  bool settings{};
  // A segment was committed with steps of an axis whose motor is off.
  bool disabled{};

  static constexpr Errors decode([[maybe_unused]] std::uint32_t word) {
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
  // 1 = driver enabled; bit = axis.
  std::uint32_t axes{};

  static constexpr MotorEnable decode([[maybe_unused]] std::uint32_t word) {
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
  // In 2^-32 ticks per clock; 8590 after reset, 100 ticks/s at 50 MHz.
  std::uint32_t rate{};

  static constexpr RateFloor decode([[maybe_unused]] std::uint32_t word) {
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
  // In 2^-16: 65536 = as segments ask, 0 = feed hold, up to 4. From 7/64 tick per clock on at most 2, from 15/64 on at most 1.
  std::uint32_t scale{};

  static constexpr Override decode([[maybe_unused]] std::uint32_t word) {
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
  // In 2^-32 per clock; after reset from 1 to 0 in 50 ms at 50 MHz. At 0 the scale stays. Slower while it falls in a segment that decelerates, or rises in one that accelerates: by half below 1/2, to a quarter below 3/4, to an eighth below 7/8; from there on it waits.
  std::uint32_t slope{};

  static constexpr OverrideSlope decode([[maybe_unused]] std::uint32_t word) {
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
  // In 2^-32 per clock. At 0 what would brake stops at once.
  std::uint32_t slope{};

  static constexpr BrakeSlope decode([[maybe_unused]] std::uint32_t word) {
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
  // In 2^-16, rounded down.
  std::uint32_t scale{};

  static constexpr Scale decode([[maybe_unused]] std::uint32_t word) {
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
  // Longest time of motion from one feed_watchdog to the next, in clocks; 0 = not watched, as after reset. A shorter one that is written in motion counts from then on.
  std::uint32_t clocks{};

  static constexpr Watchdog decode([[maybe_unused]] std::uint32_t word) {
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
  // The end stops of stop_mask brake by brake_slope; otherwise, and where it brakes already, no step is made from their clock on.
  bool stop_brakes{};
  // Begin from rest, and only at a rising edge of the start input or at the command start.
  bool waits_for_start{};
  // End stops that end all motion during this segment.
  std::uint32_t stop_mask{};
  // Axes 0..3 a quarter of a step early: their error terms start at line_ticks/2 + line_ticks/4.
  std::uint32_t ahead{};
  // Axes 0..3 a quarter of a step late: start at line_ticks/4, those of neither set at line_ticks/2.
  std::uint32_t behind{};

  static constexpr SegmentFlags decode([[maybe_unused]] std::uint32_t word) {
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
  // Ticks.
  std::uint32_t ticks{};

  static constexpr SegmentLineTicks decode([[maybe_unused]] std::uint32_t word) {
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
  // Ticks.
  std::uint32_t ticks{};

  static constexpr SegmentTicks decode([[maybe_unused]] std::uint32_t word) {
    return {
      .ticks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return ticks;
  }
};

// Tick rate at the start of the segment, low word, in 2^-64 ticks per clock.
struct SegmentRateLow {
  static constexpr std::uint32_t address = base + 0x3Cu;
  // Bits 31:0.
  std::uint32_t word{};

  static constexpr SegmentRateLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .word = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return word;
  }
};

// Tick rate, high word. The rate is at most 1/2 tick per clock.
struct SegmentRateHigh {
  static constexpr std::uint32_t address = base + 0x40u;
  // Bits 63:32.
  std::uint32_t word{};

  static constexpr SegmentRateHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .word = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return word;
  }
};

// Change of the rate per clock, signed, low word, in 2^-84 ticks per clock^2.
struct SegmentAccelerationLow {
  static constexpr std::uint32_t address = base + 0x44u;
  // Bits 31:0.
  std::uint32_t word{};

  static constexpr SegmentAccelerationLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .word = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return word;
  }
};

// Change of the rate per clock, high word.
struct SegmentAccelerationHigh {
  static constexpr std::uint32_t address = base + 0x48u;
  // Bits 63:32.
  std::uint32_t word{};

  static constexpr SegmentAccelerationHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .word = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return word;
  }
};

// Change of the acceleration per clock, signed, low word, in 2^-84 ticks per clock^3.
struct SegmentJerkLow {
  static constexpr std::uint32_t address = base + 0x4Cu;
  // Bits 31:0.
  std::uint32_t word{};

  static constexpr SegmentJerkLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .word = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return word;
  }
};

// Change of the acceleration per clock, high word. The acceleration stays where the change would take it out of its 64 bits.
struct SegmentJerkHigh {
  static constexpr std::uint32_t address = base + 0x50u;
  // Bits 63:32.
  std::uint32_t word{};

  static constexpr SegmentJerkHigh decode([[maybe_unused]] std::uint32_t word) {
    return {
      .word = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return word;
  }
};

// Steps of each axis in the whole line, without sign, 0 .. line_ticks.
struct SegmentSteps {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x54u + 4u * static_cast<std::uint32_t>(index);
  }
  // Steps.
  std::uint32_t steps{};

  static constexpr SegmentSteps decode([[maybe_unused]] std::uint32_t word) {
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
  // Not used.
  std::uint32_t any{};

  static constexpr SegmentCommit decode([[maybe_unused]] std::uint32_t word) {
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
  // Clocks that step stays high; 0 counts as 1. 50 after reset.
  std::uint32_t high{};
  // Least clocks that step stays low; 0 counts as 1. 50 after reset.
  std::uint32_t low{};
  // The falling edge is a step too, for drivers set to that: high and low are then least times. Changed only while the step pin is low.
  bool both_edges{};

  static constexpr PulseGuard decode([[maybe_unused]] std::uint32_t word) {
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
  // Least clocks from a change of direction to a step; 0 counts as 1. 10 after reset.
  std::uint32_t setup{};
  // Least clocks from a step to a change of direction; 0 counts as 1. 10 after reset.
  std::uint32_t hold{};

  static constexpr DirectionGuard decode([[maybe_unused]] std::uint32_t word) {
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
  // Steps.
  std::int32_t steps{};

  static constexpr Position decode([[maybe_unused]] std::uint32_t word) {
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
  // Steps.
  std::int32_t steps{};

  static constexpr SnapshotPosition decode([[maybe_unused]] std::uint32_t word) {
    return {
      .steps = static_cast<std::int32_t>(word),
    };
  }
  constexpr std::uint32_t encode() const {
    return static_cast<std::uint32_t>(steps);
  }
};

// Time of the last snapshot, low word.
struct SnapshotTimeLow {
  static constexpr std::uint32_t address = base + 0xF8u;
  // Clocks since reset, bits 31:0.
  std::uint32_t clocks{};

  static constexpr SnapshotTimeLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

// Time of the last snapshot, high word.
struct SnapshotTimeHigh {
  static constexpr std::uint32_t address = base + 0xFCu;
  // Clocks since reset, bits 63:32.
  std::uint32_t clocks{};

  static constexpr SnapshotTimeHigh decode([[maybe_unused]] std::uint32_t word) {
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
  // End stops that were asked for and triggered.
  std::uint32_t end_stops{};
  // The emergency stop input was active.
  bool emergency_input{};
  // Software commanded the stop.
  bool software{};
  // The watchdog was not fed.
  bool watchdog{};
  // Software commanded the brake.
  bool software_brake{};

  static constexpr StopCause decode([[maybe_unused]] std::uint32_t word) {
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

// Positions of all axes in the clock in which the last stop was asked for.
struct StopPosition {
  static constexpr std::size_t count = 8;
  static constexpr std::uint32_t address_of(std::size_t index) {
    return base + 0x104u + 4u * static_cast<std::uint32_t>(index);
  }
  // Steps.
  std::int32_t steps{};

  static constexpr StopPosition decode([[maybe_unused]] std::uint32_t word) {
    return {
      .steps = static_cast<std::int32_t>(word),
    };
  }
  constexpr std::uint32_t encode() const {
    return static_cast<std::uint32_t>(steps);
  }
};

// Time at which the last stop was asked for, low word.
struct StopTimeLow {
  static constexpr std::uint32_t address = base + 0x124u;
  // Clocks since reset, bits 31:0.
  std::uint32_t clocks{};

  static constexpr StopTimeLow decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

// Time at which the last stop was asked for, high word.
struct StopTimeHigh {
  static constexpr std::uint32_t address = base + 0x128u;
  // Clocks since reset, bits 63:32.
  std::uint32_t clocks{};

  static constexpr StopTimeHigh decode([[maybe_unused]] std::uint32_t word) {
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
  // Segments, modulo 2^32.
  std::uint32_t count{};

  static constexpr SegmentsExecuted decode([[maybe_unused]] std::uint32_t word) {
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
  // Underruns, modulo 2^32.
  std::uint32_t count{};

  static constexpr Underruns decode([[maybe_unused]] std::uint32_t word) {
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
  // Segments.
  std::uint32_t segments{};

  static constexpr MaxLevel decode([[maybe_unused]] std::uint32_t word) {
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
  // Clocks, modulo 2^32.
  std::uint32_t clocks{};

  static constexpr Stalls decode([[maybe_unused]] std::uint32_t word) {
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
  // Clocks, modulo 2^32.
  std::uint32_t clocks{};

  static constexpr AxisStalls decode([[maybe_unused]] std::uint32_t word) {
    return {
      .clocks = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return clocks;
  }
};

}  // namespace registers::step_generator
