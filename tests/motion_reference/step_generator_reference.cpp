// SPDX-License-Identifier: Apache-2.0
// Reference: what happens in one clock.
#include "tests/motion_reference/step_generator_reference.hpp"

#include <algorithm>
#include <utility>

#include "registers/step_generator_registers.hpp"

namespace motion_reference {
namespace {

namespace registers = ::registers::step_generator;

__extension__ typedef __int128 Wide;

constexpr std::uint64_t half = std::uint64_t{1} << 63u;
constexpr std::uint64_t fetch_clocks = 2;
// Of the inputs, and in stop_cause.
constexpr std::uint32_t end_stop_bits = 0xFFu, emergency_bit = 0x100u, start_bit = 0x200u;
constexpr std::uint32_t software_bit = 0x200u, watchdog_bit = 0x400u, brake_bit = 0x800u;

// Steps of an axis after so many ticks of a line.
std::uint64_t steps_after(std::uint64_t ticks, std::uint64_t steps, std::uint64_t first_error,
                          std::uint64_t line_ticks) {
  const Wide sum = Wide(ticks) * Wide(steps) + Wide(first_error);
  return static_cast<std::uint64_t>(sum / Wide(line_ticks));
}

}  // namespace

void StepGeneratorReference::apply(const Stimulus& stimulus) {
  if (stimulus.kind == Stimulus::Kind::inputs) {
    inputs_ = stimulus.value;
  } else {
    pending_ = Write{stimulus.address, stimulus.value};
  }
}

Pins StepGeneratorReference::pins() const {
  Pins result;
  for (std::size_t i = 0; i < axes; ++i) {
    const Axis& axis = axis_[i];
    const bool pulse = axis.stepped && now_ < *axis.stepped + axis.guard.high;
    if (axis.guard.both_edges ? axis.high : pulse) result.step |= 1u << i;
    if (axis.backward) result.direction |= 1u << i;
  }
  return result;
}

StepGeneratorReference::Positions StepGeneratorReference::positions() const {
  Positions result{};
  for (std::size_t i = 0; i < axes; ++i) result[i] = axis_[i].position;
  return result;
}

bool StepGeneratorReference::idle() const {
  const auto finished = [this](const Axis& axis) {
    return now_ + 1 >= free_again(axis) && axis.backward == axis.wanted_backward &&
           (!axis.stepped || now_ + 1 >= *axis.stepped + axis.guard.hold) &&
           (!axis.turned || now_ + 1 >= *axis.turned + axis.guard.setup);
  };
  return !moving() && queue_.empty() && std::ranges::all_of(axis_, finished);
}

bool StepGeneratorReference::steps_at_next_tick(const Axis& axis) const {
  return steps_after(line_ticks_done_ + 1, axis.steps, axis.first_error, line_ticks_) >
         steps_after(line_ticks_done_, axis.steps, axis.first_error, line_ticks_);
}

std::uint64_t StepGeneratorReference::free_again(const Axis& axis) const {
  if (!axis.stepped) return 0;
  const Guard& guard = axis.guard;
  if (guard.both_edges) return *axis.stepped + (axis.high ? guard.high : guard.low);
  return *axis.stepped + guard.high + guard.low;
}

bool StepGeneratorReference::turns_in_next_clock(const Axis& axis) const {
  const std::uint64_t next = now_ + 1;
  const bool held = !axis.stepped || next >= *axis.stepped + axis.guard.hold;
  const bool settled = !axis.turned || next >= *axis.turned + axis.guard.setup;
  return axis.backward != axis.wanted_backward && held && settled;
}

// The pins follow the base by a clock.
bool StepGeneratorReference::may_follow_a_tick(const Axis& axis) const {
  const std::uint64_t shown = now_ + 2;
  if (shown < free_again(axis)) return false;
  if (axis.backward == axis.wanted_backward) {
    return !axis.turned || shown >= *axis.turned + axis.guard.setup;
  }
  return turns_in_next_clock(axis) && shown >= now_ + 1 + axis.guard.setup;
}

bool StepGeneratorReference::head_ready() const {
  return !queue_.empty() && now_ >= queue_.front().ready && now_ >= next_ready_;
}

bool StepGeneratorReference::waiting() const {
  return !base_ && head_ready() && queue_.front().segment.waits_for_start;
}

StepGeneratorReference::Commands StepGeneratorReference::commands() const {
  const bool command = current_ && current_->address == registers::Command::address;
  const auto bits = registers::Command::decode(command ? current_->value : 0);
  return {bits.flush,    bits.stop,  bits.brake,         bits.acknowledge_stop,
          bits.snapshot, bits.start, bits.feed_watchdog, bits.positions_known};
}

std::uint32_t StepGeneratorReference::end_stops_hit() const {
  if (!moving()) return 0;
  const Segment& segment = executing_ ? executed_ : *base_;
  std::uint32_t ends = segment.stop_on_release ? ~inputs_ : inputs_;
  if (segment.stop_on_change) ends &= inputs_ ^ inputs_before_;
  // What brakes already may stay as it is.
  if (braking_) ends &= ~(brakers_ & ~(inputs_ ^ inputs_before_));
  return ends & segment.stop_mask & end_stop_bits;
}

void StepGeneratorReference::clock() {
  const Commands asked = commands();
  const std::uint32_t hits = end_stops_hit();
  const bool end_stop = hits != 0;
  const std::uint32_t immediate = (inputs_ & emergency_bit) | (asked.stop ? software_bit : 0) |
                                  (watchdog_expired_ ? watchdog_bit : 0);
  const bool braked = braking_ && (!base_ || pace_.standing());
  const bool along_ramp = end_stop || asked.brake;
  const bool at_once = immediate != 0 ||
                       (end_stop && (braking_ || !(executing_ ? executed_ : *base_).stop_brakes)) ||
                       braked || (no_ramp_ && (along_ramp || braking_));
  const bool stop = stopped_ || at_once;
  refuses_segments_ = stop || along_ramp || braking_;
  no_ramp_ = pace_.brake_slope == 0;

  // The base decides on the state of this clock.
  const bool full = queue_.size() == queue_depth;
  const bool active = base_.has_value();
  const std::uint64_t leap = pace_.leap();
  const bool due = active && !stop && phase_ + leap * rate_ < phase_;
  const bool tick = due && ticks();
  const bool one_left = active && ticks_done_ + 1 == base_->ticks;
  const bool last = tick && one_left;
  const bool waits = !queue_.empty() && queue_.front().segment.waits_for_start;
  const bool start = asked.start || (inputs_ & ~inputs_before_ & start_bit) != 0;
  const bool from_rest = !active && run_ && (start || !waits);
  const bool taking = head_ready() && !stop && ((last && !waits) || from_rest);
  const Positions positions_now = positions();
  if (std::exchange(was_hit_, false)) stop_moment_.positions = positions_now;

  std::uint64_t rate = active ? rate_ : 0;
  if (head_ready() && (!active || one_left)) rate = std::max(rate, queue_.front().segment.rate);
  pace_.clock(active, braking_, due && !tick, static_cast<std::int64_t>(acceleration_before_),
              std::max(rate, rate_floor_));
  acceleration_before_ = acceleration_;
  watch(moving(), asked.feed_watchdog);
  // Queue, axes and stops follow what it decided in the clock before.
  const Decision decided = std::exchange(decided_, {});
  turn_axes();
  if (decided.tick && (inputs_ & emergency_bit) == 0) step_axes();
  if (decided.taken) begin_segment(*decided.taken);
  executing_ = active && !stop;
  if (base_) executed_ = *base_;
  if (tick) ++ticks_done_;
  if (active && !stop && (!due || tick)) integrate(leap);
  if (asked.positions_known) positions_lost_ = false;
  if (current_) obey(*current_);
  cut_motors_off(stopped_);
  if (last) {
    if (!head_ready() && !base_->ends_motion) ++counters_.underruns;
    base_.reset();
    if (!taking) phase_ = 0;
  }
  if (taking) take();
  decided_.tick = tick;
  counters_.max_level = std::max(counters_.max_level, queue_.size());
  if (asked.flush) forget_queue();

  if (asked.snapshot) snapshot_ = {positions_now, now_};
  brakers_ &= ~(inputs_ ^ inputs_before_);
  if ((at_once || along_ramp) && !braking_ && !stopped_) {
    brakers_ = hits;
    // The axes have still to make the tick of the clock before.
    stop_moment_.clock = now_;
    was_hit_ = true;
    stop_cause_ = hits | immediate | (asked.brake ? brake_bit : 0);
    braking_ = !at_once;
  } else if (at_once && !stopped_) {
    stop_cause_ |= hits | immediate;
  }
  if (at_once && !stopped_) {
    begin_stop();
  } else if (asked.acknowledge_stop && !asked.stop && !asked.brake &&
             (inputs_ & emergency_bit) == 0) {
    stopped_ = false;
  }
  inputs_before_ = inputs_;
  queue_was_full_ = full;
  // The registers pass a write on in the clock after it.
  current_ = std::exchange(pending_, std::nullopt);
  ++now_;
}

bool StepGeneratorReference::ticks() {
  bool all_ready = true;
  for (std::size_t i = 0; i < axes; ++i) {
    if (steps_at_next_tick(axis_[i]) && !may_follow_a_tick(axis_[i])) {
      all_ready = false;
      ++counters_.axis_stalls[i];
    }
  }
  if (!all_ready) ++counters_.stalls;
  return all_ready;
}

void StepGeneratorReference::turn_axes() {
  for (Axis& axis : axis_) {
    if (!turns_in_next_clock(axis)) continue;
    axis.backward = axis.wanted_backward;
    axis.turned = now_ + 1;
  }
}

void StepGeneratorReference::step_axes() {
  for (Axis& axis : axis_) {
    if (!steps_at_next_tick(axis)) continue;
    axis.stepped = now_ + 1;
    axis.high = !axis.high && axis.guard.both_edges;
    const auto position = static_cast<std::uint32_t>(axis.position);
    axis.position = static_cast<std::int32_t>(axis.backward ? position - 1 : position + 1);
  }
  ++line_ticks_done_;
}

void StepGeneratorReference::integrate(std::uint64_t leap) {
  if (leap == 0) return;
  phase_ += leap * rate_;
  const Wide change = (Wide(static_cast<std::int64_t>(acceleration_)) >> 20) * Wide(leap);
  const Wide rate = Wide(rate_) + change;
  rate_ = static_cast<std::uint64_t>(std::clamp(rate, Wide(rate_floor_), Wide(half)));
  // Neither the change nor the acceleration leaves its 64 bits.
  const Wide jerk = base_->jerk;
  std::uint64_t times = leap;
  while (times > 1 && jerk * Wide(times) != static_cast<std::int64_t>(jerk * Wide(times))) {
    times /= 2;
  }
  const Wide more = jerk * Wide(times);
  const Wide acceleration = Wide(static_cast<std::int64_t>(acceleration_)) + more;
  if (acceleration == static_cast<std::int64_t>(acceleration)) {
    acceleration_ = static_cast<std::uint64_t>(acceleration);
  }
}

void StepGeneratorReference::take() {
  base_ = queue_.front().segment;
  decided_.taken = base_;
  next_ready_ = now_ + fetch_clocks;
  ++counters_.segments;
  ticks_done_ = 0;
  rate_ = std::max(base_->rate, rate_floor_);
  acceleration_ = static_cast<std::uint64_t>(base_->acceleration);
}

void StepGeneratorReference::begin_segment(const Segment& segment) {
  // Unless it was flushed since.
  if (!queue_.empty()) queue_.pop_front();
  if (segment.continues_line) return;
  line_ticks_ = segment.line_ticks;
  line_ticks_done_ = 0;
  for (std::size_t i = 0; i < axes; ++i) {
    axis_[i].steps = segment.steps[i];
    axis_[i].first_error = line_ticks_ / 2;
    if ((segment.ahead >> i & 1u) != 0) axis_[i].first_error += line_ticks_ / 4;
    if ((segment.behind >> i & 1u) != 0) axis_[i].first_error = line_ticks_ / 4;
    if (axis_[i].steps != 0) axis_[i].wanted_backward = (segment.backward >> i & 1u) != 0;
  }
}

}  // namespace motion_reference
