// SPDX-License-Identifier: Apache-2.0
// Reference: what happens in one clock.
#include "tests/motion_reference/step_generator_reference.hpp"

#include <algorithm>
#include <utility>

#include "drivers/registers/step_generator_registers.hpp"

namespace motion_reference {
namespace {

namespace registers = ::registers::step_generator;

__extension__ typedef __int128 Wide;

constexpr std::uint64_t half = std::uint64_t{1} << 63u;
constexpr std::uint64_t fetch_clocks = 2;
constexpr std::uint32_t emergency_bit = 0x100u, software_bit = 0x200u;

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
    if (axis.rose && now_ < *axis.rose + axis.guard.high) result.step |= 1u << i;
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
    return !axis.rose || now_ + 1 >= *axis.rose + axis.guard.high + axis.guard.low;
  };
  return !active_ && queue_.empty() && std::ranges::all_of(axis_, finished);
}

bool StepGeneratorReference::steps_at_next_tick(const Axis& axis) const {
  return steps_after(line_ticks_done_ + 1, axis.steps, axis.first_error, line_ticks_) >
         steps_after(line_ticks_done_, axis.steps, axis.first_error, line_ticks_);
}

bool StepGeneratorReference::may_rise_in_next_clock(const Axis& axis) const {
  const std::uint64_t next = now_ + 1;
  return axis.backward == axis.wanted_backward &&
         (!axis.rose || next >= *axis.rose + axis.guard.high + axis.guard.low) &&
         (!axis.turned || next >= *axis.turned + axis.guard.setup);
}

bool StepGeneratorReference::head_ready() const {
  return !queue_.empty() && now_ >= queue_.front().ready && now_ >= next_ready_;
}

void StepGeneratorReference::clock() {
  const bool command = current_ && current_->address == registers::Command::address;
  const auto commands = registers::Command::decode(command ? current_->value : 0);

  const std::uint32_t hits = active_ ? inputs_ & active_->stop_mask : 0;
  const std::uint32_t cause = hits | (inputs_ & emergency_bit) | (commands.stop ? software_bit : 0);
  const bool stop = stopped_ || cause != 0;

  // Decided on the state of this clock, then done.
  const bool due = active_ && !stop && phase_ + rate_ < phase_;
  const bool tick = due && ticks();
  const bool last = tick && ticks_done_ + 1 == active_->ticks;
  const bool taking = head_ready() && !stop && (last || (!active_ && run_));
  const Positions positions_now = positions();

  turn_axes();
  if (tick) make_tick();
  if (active_ && !stop && (!due || tick)) integrate();
  if (current_) obey(*current_);
  if (last) {
    if (!taking && !active_->ends_motion) ++counters_.underruns;
    active_.reset();
    if (!taking) phase_ = 0;
  }
  if (taking) take();
  counters_.max_level = std::max(counters_.max_level, queue_.size());
  if (commands.flush) forget_queue();

  if (commands.snapshot) snapshot_ = {positions_now, now_};
  if (cause != 0 && !stopped_) {
    stop_moment_ = {positions_now, now_};
    begin_stop(cause);
  } else if (commands.acknowledge_stop && (inputs_ & emergency_bit) == 0) {
    stopped_ = false;
  }
  // The registers pass a write on in the clock after it.
  current_ = std::exchange(pending_, std::nullopt);
  ++now_;
}

bool StepGeneratorReference::ticks() {
  bool all_ready = true;
  for (std::size_t i = 0; i < axes; ++i) {
    if (steps_at_next_tick(axis_[i]) && !may_rise_in_next_clock(axis_[i])) {
      all_ready = false;
      ++counters_.axis_stalls[i];
    }
  }
  if (!all_ready) ++counters_.stalls;
  return all_ready;
}

void StepGeneratorReference::turn_axes() {
  const std::uint64_t next = now_ + 1;
  for (Axis& axis : axis_) {
    const bool held = !axis.rose || next >= *axis.rose + axis.guard.hold;
    const bool settled = !axis.turned || next >= *axis.turned + axis.guard.setup;
    if (axis.backward != axis.wanted_backward && held && settled) {
      axis.backward = axis.wanted_backward;
      axis.turned = next;
    }
  }
}

void StepGeneratorReference::make_tick() {
  for (Axis& axis : axis_) {
    if (!steps_at_next_tick(axis)) continue;
    axis.rose = now_ + 1;
    const auto position = static_cast<std::uint32_t>(axis.position);
    axis.position = static_cast<std::int32_t>(axis.backward ? position - 1 : position + 1);
  }
  ++line_ticks_done_;
  ++ticks_done_;
}

void StepGeneratorReference::integrate() {
  phase_ += rate_;
  const Wide change = Wide(static_cast<std::int64_t>(acceleration_)) >> 20;
  const Wide rate = Wide(rate_) + change;
  rate_ = static_cast<std::uint64_t>(std::clamp(rate, Wide(rate_floor_), Wide(half)));
  acceleration_ += static_cast<std::uint64_t>(active_->jerk);
}

void StepGeneratorReference::take() {
  active_ = queue_.front().segment;
  queue_.pop_front();
  next_ready_ = now_ + fetch_clocks;
  ++counters_.segments;
  ticks_done_ = 0;
  rate_ = std::max(active_->rate, rate_floor_);
  acceleration_ = static_cast<std::uint64_t>(active_->acceleration);
  if (active_->continues_line) return;
  line_ticks_ = active_->line_ticks;
  line_ticks_done_ = 0;
  for (std::size_t i = 0; i < axes; ++i) {
    axis_[i].steps = active_->steps[i];
    axis_[i].first_error = line_ticks_ / 2;
    if ((active_->ahead >> i & 1u) != 0) axis_[i].first_error += line_ticks_ / 4;
    if ((active_->behind >> i & 1u) != 0) axis_[i].first_error = line_ticks_ / 4;
    if (axis_[i].steps != 0) axis_[i].wanted_backward = (active_->backward >> i & 1u) != 0;
  }
}

void StepGeneratorReference::begin_stop(std::uint32_t cause) {
  stopped_ = true;
  stop_cause_ = cause;
  active_.reset();
  phase_ = 0;
  forget_queue();
}

void StepGeneratorReference::forget_queue() {
  queue_.clear();
  draft_.forget();
  line_left_ = 0;
}

}  // namespace motion_reference
