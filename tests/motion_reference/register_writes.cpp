// SPDX-License-Identifier: Apache-2.0
// Reference: what a write to each register means.
#include <algorithm>

#include "registers/step_generator_registers.hpp"
#include "tests/motion_reference/step_generator_reference.hpp"

namespace motion_reference {
namespace {

namespace registers = ::registers::step_generator;

constexpr std::uint64_t fetch_clocks = 2;
constexpr std::uint32_t position_error = 16, settings_error = 32;
constexpr std::uint32_t emergency_bit = 0x100;

std::uint64_t at_least_one(std::uint32_t clocks) { return std::max(clocks, 1u); }

// The place of an address in an array of registers, or a place beyond all axes.
template <class Array>
std::size_t index_in(std::uint32_t address) {
  const std::uint32_t first = Array::address_of(0);
  return address < first || address >= Array::address_of(Array::count) ? axes
                                                                       : (address - first) / 4;
}

}  // namespace

void StepGeneratorReference::obey(const Write& write) {
  const auto [address, value] = write;
  if (address == registers::Control::address) {
    run_ = registers::Control::decode(value).run;
  } else if (address == registers::RateFloor::address) {
    set_rate_floor(registers::RateFloor::decode(value).rate);
  } else if (address == registers::MotorEnable::address) {
    switch_motors(registers::MotorEnable::decode(value).axes);
  } else if (address == registers::Command::address) {
    if (registers::Command::decode(value).clear_errors) errors_ = 0;
  } else if (address == registers::Override::address) {
    pace_.target = std::uint64_t{registers::Override::decode(value).scale} << 16u;
  } else if (address == registers::OverrideSlope::address) {
    pace_.slope = value;
  } else if (address == registers::BrakeSlope::address) {
    pace_.brake_slope = value;
  } else if (address == registers::Watchdog::address) {
    watchdog_limit_ = value;
  } else if (address == registers::SegmentCommit::address) {
    commit();
  } else if (const auto axis = index_in<registers::PulseGuard>(address); axis < axes) {
    set_pulse_guard(axis_[axis], value);
  } else if (const auto axis_of_direction = index_in<registers::DirectionGuard>(address);
             axis_of_direction < axes) {
    set_direction_guard(axis_[axis_of_direction], value);
  } else if (const auto axis_of_position = index_in<registers::Position>(address);
             axis_of_position < axes) {
    set_position(axis_of_position, value);
  } else if (address >= registers::SegmentFlags::address &&
             address < registers::SegmentCommit::address) {
    if (!queue_was_full_) {
      draft_.write(address, value, line_left_);
    } else if (address == registers::SegmentFlags::address) {
      draft_.forget();
    }
  }
}

void StepGeneratorReference::commit() {
  if (refuses_segments_) {
    errors_ |= static_cast<std::uint32_t>(Refusal::while_stopped);
  } else if (queue_was_full_) {
    errors_ |= static_cast<std::uint32_t>(Refusal::queue_full);
  } else if (!draft_.complete()) {
    errors_ |= static_cast<std::uint32_t>(Refusal::incomplete);
  } else if (!draft_.executable()) {
    errors_ |= static_cast<std::uint32_t>(Refusal::illegal);
  } else if (!driven(draft_.segment())) {
    errors_ |= static_cast<std::uint32_t>(Refusal::disabled);
  } else {
    const Segment segment = draft_.segment();
    if (!segment.continues_line) line_steps_ = segment.steps;
    line_left_ = (segment.continues_line ? line_left_ : segment.line_ticks) - segment.ticks;
    queue_.push_back({segment, now_ + fetch_clocks});
  }
  draft_.forget();
}

bool StepGeneratorReference::driven(const Segment& segment) const {
  const auto& steps = segment.continues_line ? line_steps_ : segment.steps;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    if (steps[axis] != 0 && (motors_ >> axis & 1u) == 0) return false;
  }
  return true;
}

void StepGeneratorReference::set_rate_floor(std::uint32_t rate) {
  if (idle() && rate != 0) {
    rate_floor_ = std::uint64_t{rate} << 32u;
  } else {
    errors_ |= settings_error;
  }
}

// A new guard counts from the next step and turn on: those before have kept the old one.
void StepGeneratorReference::set_pulse_guard(Axis& axis, std::uint32_t value) {
  const auto guard = registers::PulseGuard::decode(value);
  if (!idle() || (axis.high && guard.both_edges != axis.guard.both_edges)) {
    errors_ |= settings_error;
    return;
  }
  axis.guard.high = at_least_one(guard.high);
  axis.guard.low = at_least_one(guard.low);
  axis.guard.both_edges = guard.both_edges;
  axis.stepped.reset();
  axis.turned.reset();
}

void StepGeneratorReference::set_direction_guard(Axis& axis, std::uint32_t value) {
  if (!idle()) {
    errors_ |= settings_error;
    return;
  }
  const auto guard = registers::DirectionGuard::decode(value);
  axis.guard.setup = at_least_one(guard.setup);
  axis.guard.hold = at_least_one(guard.hold);
  axis.stepped.reset();
  axis.turned.reset();
}

void StepGeneratorReference::switch_motors(std::uint32_t wanted) {
  wanted &= (1u << axes) - 1;
  const bool in_motion = moving() || !queue_.empty();
  const bool cut = motors_cut_ || (inputs_ & emergency_bit) != 0;
  if ((in_motion && (motors_ & ~wanted) != 0) || (cut && wanted != 0)) {
    errors_ |= settings_error;
  } else {
    motors_ = wanted;
  }
}

void StepGeneratorReference::set_position(std::size_t axis, std::uint32_t value) {
  if (idle()) {
    axis_[axis].position = static_cast<std::int32_t>(value);
  } else {
    errors_ |= position_error;
  }
}

}  // namespace motion_reference
