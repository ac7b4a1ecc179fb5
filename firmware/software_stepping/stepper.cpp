// SPDX-License-Identifier: Apache-2.0
// Hands over from tick to tick what the short way does not cover: segments, lines, stops, delays.
#include "software_stepping/stepper.hpp"

#include <algorithm>

#include "drivers/registers/end_stops_registers.hpp"
#include "platform/division.hpp"
#include "software_stepping/interrupts.hpp"

namespace software_stepping {
namespace {

constexpr std::uint32_t most_line_ticks = 0x7FFF'FFFF;
constexpr std::uint64_t highest_rate = std::uint64_t{1} << 63;
constexpr Interval shortest_careful_interval = 1u << 29;

std::uint32_t magnitude(std::int32_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  return value < 0 ? 0 - word : word;
}

// Bresenham's error term with which an axis begins a line (see motion/segment.hpp).
std::uint32_t first_error(const QueuedLine& line, std::size_t axis) {
  const std::uint32_t half = line.ticks / 2;
  const std::uint32_t quarter = line.ticks / 4;
  if (line.start.behind.contains(static_cast<units::Axis>(axis))) return quarter;
  return line.start.ahead.contains(static_cast<units::Axis>(axis)) ? half + quarter : half;
}

// Steps of an axis after so many ticks of the line.
std::int32_t steps_after(const QueuedLine& line, std::uint32_t ticks, std::size_t axis) {
  const std::uint32_t steps = magnitude(line.steps[axis]);
  if (steps == 0) return 0;
  const std::uint64_t sum = std::uint64_t{ticks} * steps + first_error(line, axis);
  const auto done = static_cast<std::int32_t>(platform::divide(sum, line.ticks));
  return line.steps[axis] < 0 ? -done : done;
}

std::uint64_t deadline_of(const Tick& tick) {
  return std::uint64_t{tick.deadline_high} << 32 | tick.deadline_low;
}

void set_deadline(Tick& tick, std::uint64_t clocks) {
  tick.deadline_low = static_cast<std::uint32_t>(clocks);
  tick.deadline_high = static_cast<std::uint32_t>(clocks >> 32);
}

void prepare(const motion::Segment& segment, QueuedLine& line) {
  line = {};
  line.ticks = segment.line_ticks;
  line.start = segment.start;
  line.steps = segment.steps;
  std::size_t count = 0;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    const std::uint32_t steps = magnitude(segment.steps[axis]);
    if (steps == 0) continue;
    const auto pin = static_cast<std::uint8_t>(1u << axis);
    line.moving |= pin;
    if (segment.steps[axis] < 0) line.backward |= pin;
    if (steps == line.ticks) {
      line.leader |= pin;
    } else {
      line.followers[count++] = {static_cast<std::int32_t>(first_error(line, axis) - line.ticks),
                                 static_cast<std::int32_t>(steps), pin};
    }
  }
}

bool executable(const motion::Segment& segment, std::uint32_t ticks_left) {
  if (segment.ticks == 0 || segment.ticks > ticks_left) return false;
  if (segment.rate > highest_rate || segment.jerk != 0) return false;
  if (segment.stop_on_change || segment.stop_on_release || segment.stop_brakes ||
      segment.waits_for_start) {
    return false;
  }
  if (segment.continues_line) return true;
  if (segment.line_ticks > most_line_ticks) return false;
  const auto too_many = [&](std::int32_t steps) { return magnitude(steps) > segment.line_ticks; };
  return std::ranges::none_of(segment.steps, too_many) &&
         (segment.start.ahead.bits() & segment.start.behind.bits()) == 0;
}

}  // namespace

void Stepper::configure(const Guard& guard, Interval longest_interval) {
  guard_ = guard;
  longest_interval_ = longest_interval;
  tick_.high_clocks = guard.high;
  tick_.margin_clocks =
      std::max(static_cast<std::int32_t>(guard.low - shortest_latency_clocks), std::int32_t{1});
  permitted_ = true;
}

std::uint32_t Stepper::free() const {
  return std::min(queue_depth - segments_.level(), line_depth - lines_.level());
}

bool Stepper::append(const motion::Segment& segment) {
  const std::uint32_t left = segment.continues_line ? unassigned_ticks_ : segment.line_ticks;
  if (free() == 0 || stopped_ || !executable(segment, left)) return false;
  QueuedSegment& entry = segments_.to_write();
  entry = {.first_interval = first_interval(segment.rate, segment.acceleration, longest_interval_),
           .ramp = Ramp::of(segment.acceleration),
           .ticks = segment.ticks,
           .stop_mask = segment.stop_mask,
           .begins_line = !segment.continues_line,
           .ends_motion = segment.ends_motion};
  if (entry.begins_line) prepare(segment, lines_.to_write());
  unassigned_ticks_ = left - segment.ticks;

  const WithoutInterrupts guarded;
  if (stopped_) return false;
  if (entry.begins_line) lines_.write();
  segments_.write();
  counters_.max_level = std::max(counters_.max_level, segments_.level());
  begin_motion();
  return true;
}

void Stepper::permit_motion(bool permitted) {
  const WithoutInterrupts guarded;
  permitted_ = permitted;
  begin_motion();
}

void Stepper::flush() {
  const WithoutInterrupts guarded;
  segments_.keep(moving_ ? 1 : 0);
  lines_.keep(line_open_ ? 1 : 0);
  unassigned_ticks_ = 0;
}

void Stepper::stop() {
  const WithoutInterrupts guarded;
  stop(std::uint8_t{0});
  set_timer();
}

bool Stepper::set_position(std::size_t axis, std::int32_t steps) {
  const WithoutInterrupts guarded;
  if (moving_ || segments_.level() != 0) return false;
  line_start_[axis] = steps;
  return true;
}

void Stepper::set_alarm(std::uint64_t clocks) {
  const WithoutInterrupts guarded;
  alarm_ = clocks;
  alarm_rang_ = false;
  // Ticks that come the short way come often enough to look at the time after each.
  if (tick_.mode == Mode::careful) set_timer();
}

bool Stepper::alarm_has_passed() const { return long_clocks() >= alarm_; }

std::uint32_t Stepper::ticks_done() const {
  if (!moving_) return line_ticks_before_;
  return line_ticks_before_ + segments_.to_read().ticks - tick_.left;
}

Stepper::Positions Stepper::positions() const {
  const WithoutInterrupts guarded;
  Positions result = line_start_;
  if (!line_open_) return result;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    result[axis] += steps_after(lines_.to_read(), ticks_done(), axis);
  }
  return result;
}

void Stepper::attend(Attention reason) {
  // Whoever comes with another reason has just ended a pulse.
  if (reason != Attention::careful) pulse_is_over();
  switch (reason) {
    case Attention::careful:
      if (make_tick_with_care()) break;
      // An alarm just before a tick does not make the tick late.
      set_timer();
      return;
    case Attention::segment_ends:
      end_segment();
      break;
    case Attention::interval:
      tick_.pins = next_pins(tick_);
      go_on_after(next_interval(tick_.interval, tick_.ramp, longest_interval_));
      break;
    case Attention::late:
      break;
  }
  schedule();
}

bool Stepper::make_tick_with_care() {
  const std::uint64_t now = long_clocks();
  // It ends the sleep by itself; the interrupt shall not come again for it.
  if (now >= alarm_) alarm_rang_ = true;
  if (!moving_ || now < deadline_of(tick_)) return false;
  const std::uint8_t mask = segments_.to_read().stop_mask;
  if (mask != 0) {
    const auto triggered = platform::read<registers::end_stops::Status>().triggered;
    if (const auto hits = static_cast<std::uint8_t>(triggered & mask)) {
      stop(hits);
      return true;
    }
  }
  raise(tick_);
  fall(tick_);
  pulse_is_over();
  if (--tick_.left == 0) {
    end_segment();
    return true;
  }
  const Interval interval = Interval{tick_.interval_high} << 32 | tick_.interval;
  tick_.pins = next_pins(tick_);
  go_on_after(next_interval(interval, tick_.ramp, longest_interval_));
  return true;
}

// Its last pulse is over.
void Stepper::end_segment() {
  const QueuedSegment& segment = segments_.to_read();
  line_ticks_before_ += segment.ticks;
  const bool ends_motion = segment.ends_motion;
  segments_.free();
  if (segments_.level() != 0) {
    begin_segment();
    return;
  }
  if (!ends_motion) ++counters_.underruns;
  come_to_rest();
}

void Stepper::begin_segment() {
  const QueuedSegment& segment = segments_.to_read();
  if (!moving_) {
    // From rest time begins now.
    set_deadline(tick_, long_clocks());
    tick_.fraction = 0;
  }
  if (segment.begins_line) {
    if (line_open_) end_line();
    begin_line();
  }
  moving_ = true;
  ++counters_.segments;
  tick_.left = segment.ticks;
  tick_.ramp = segment.ramp;
  tick_.pins = next_pins(tick_);
  go_on_after(segment.first_interval);
}

// Its positions are the next one's start.
void Stepper::end_line() {
  const QueuedLine& line = lines_.to_read();
  const bool whole = line_ticks_before_ == line.ticks;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    line_start_[axis] += whole ? line.steps[axis] : steps_after(line, line_ticks_before_, axis);
  }
  lines_.free();
  line_open_ = false;
}

void Stepper::begin_line() {
  line_open_ = true;
  QueuedLine& line = lines_.to_read();
  line_ticks_before_ = 0;
  tick_.leader = line.leader;
  tick_.followers = line.followers.data();
  tick_.line_ticks = static_cast<std::int32_t>(line.ticks);
  const auto direction = static_cast<std::uint8_t>((direction_ & ~line.moving) | line.backward);
  if (direction == direction_) return;
  direction_ = direction;
  while (platform::clocks() - tick_.rose < guard_.direction_hold) {
  }
  platform::write(registers::step_pins::Direction{direction});
  earliest_ = std::max(earliest_, long_clocks() + guard_.direction_setup);
}

void Stepper::go_on_after(Interval interval) {
  tick_.interval = static_cast<std::uint32_t>(interval);
  tick_.interval_high = static_cast<std::uint32_t>(interval >> 32);
  if (interval >= shortest_careful_interval || segments_.to_read().stop_mask != 0) {
    tick_.mode = Mode::careful;
  } else {
    tick_.mode = tick_.ramp == Ramp{} ? Mode::even : Mode::ramp;
  }
  const Interval sum = interval + tick_.fraction;
  tick_.fraction = static_cast<std::uint32_t>(sum & 0xFFFF);
  set_deadline(tick_, deadline_of(tick_) + (sum >> interval_fraction_bits));
}

// A tick that is late, or that the guard forbids as yet, delays all that follow: as in hardware the
// path stays, and the clocks are counted.
void Stepper::schedule() {
  if (moving_) {
    const std::uint64_t now = long_clocks();
    const std::uint64_t deadline = deadline_of(tick_);
    const std::uint64_t earliest = std::max(now, earliest_);
    if (deadline < now) ++counters_.late_ticks;
    if (deadline < earliest) {
      counters_.delay_clocks += static_cast<std::uint32_t>(earliest - deadline);
      set_deadline(tick_, earliest);
    }
  }
  set_timer();
}

void Stepper::set_timer() {
  std::uint64_t next = alarm_rang_ ? never : alarm_;
  if (moving_) {
    // Ticks that come the short way end sleep often enough for an alarm.
    const std::uint64_t deadline = deadline_of(tick_);
    next = tick_.mode == Mode::careful ? std::min(deadline, next) : deadline;
  }
  platform::write(registers::timer::CompareLow{static_cast<std::uint32_t>(next)});
  platform::write(registers::timer::CompareHigh{static_cast<std::uint32_t>(next >> 32)});
}

void Stepper::pulse_is_over() {
  earliest_ = long_clocks() + guard_.low;
  earliest_ -= std::min(guard_.low, shortest_latency_clocks);
}

// With interrupts kept out.
void Stepper::begin_motion() {
  if (moving_ || !permitted_ || segments_.level() == 0) return;
  begin_segment();
  schedule();
}

// A line that was left in its middle may still be continued.
void Stepper::come_to_rest() {
  moving_ = false;
  tick_.mode = Mode::careful;
  if (line_ticks_before_ == lines_.to_read().ticks) end_line();
}

// No step from now on: a pulse that is out has been ended by whoever made it.
void Stepper::stop(std::uint8_t end_stops) {
  if (stopped_) return;
  stopped_ = true;
  stop_cause_ = end_stops;
  stop_clock_ = long_clocks();
  if (moving_) {
    line_ticks_before_ = ticks_done();
    come_to_rest();
  }
  if (line_open_) end_line();
  segments_.keep(0);
  lines_.keep(0);
  unassigned_ticks_ = 0;
}

}  // namespace software_stepping
