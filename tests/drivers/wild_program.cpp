// SPDX-License-Identifier: Apache-2.0
// Time, inputs and what they permit; the bus, and what a write means by the register's description.
#include "tests/drivers/wild_program.hpp"

#include <algorithm>
#include <utility>

namespace tests {

namespace reg = registers::step_generator;

namespace {
constexpr std::uint64_t never = ~std::uint64_t{0} / 2;
}

WildProgram::WildProgram(std::uint32_t seed, Clocks clocks)
    : random_(seed), all_clocks_(clocks == Clocks::all) {
  model_->reset = 1;
  clock(4);
  model_->reset = 0;
  stop_on_.mask = static_cast<std::uint8_t>(chance(3) ? 0 : word());
  stop_on_.on_change = chance(3);
  stop_on_.on_release = chance(3);
  stop_on_.brakes = chance(2);
}

void WildProgram::change_inputs() {
  if (model_->reset != 0) return;
  if (chance(150)) model_->end_stops = static_cast<std::uint8_t>(chance(3) ? word() : 0);
  if (chance(60)) model_->end_stops ^= static_cast<std::uint8_t>(1u << below(8));
  if (model_->emergency_stop != 0 ? chance(9) : chance(2500)) model_->emergency_stop ^= 1;
  if (chance(50)) model_->start ^= 1;
}

void WildProgram::clock(std::uint32_t count) {
  for (; count > 0; --count) {
    change_inputs();
    // The pins follow by a clock, but not in an emergency.
    const char* const judged = judge();
    const char* const before = std::exchange(forbidden_, judged);
    const char* const forbidden = model_->emergency_stop != 0 ? judged : before;
    const Inputs inputs{model_->end_stops, model_->emergency_stop, model_->start};
    const bool counts = inputs != inputs_ || model_->reset != 0;
    inputs_ = inputs;
    const std::uint32_t enabled = model_->enable;
    const bool moved = model_->moving != 0;
    model_->clk = all_clocks_ || counts || model_->at_rest == 0;
    model_->always_clk = model_->bus_clk = 1;
    model_->eval();
    ++now_;
    pins_.watch(now_, model_->step, model_->direction, model_->enable, forbidden);
    if (inputs.emergency != 0) {
      expect(model_->enable == 0, "no motor is on in an emergency");
    } else {
      expect(!moved || (enabled & ~model_->enable) == 0, "no motor is switched off in motion");
    }
    model_->clk = model_->always_clk = model_->bus_clk = 0;
    model_->eval();
  }
}

// Why no step may come with the next edge, from the inputs that stop motion or permit it again.
const char* WildProgram::judge() {
  if (std::exchange(stop_begins_, false)) stop_positions_ = pins_.positions();
  const char* reason = stopped_ ? "a step between stop and acknowledgement" : nullptr;
  const bool emergency = model_->emergency_stop != 0;
  if (slope_age_ < 8) ++slope_age_;
  if (command_.acknowledge_stop && !command_.stop && !command_.brake && !emergency) {
    // A brake that is not over goes on; whether it is, no pin shows.
    brake_may_last_ = !stopped_ && (braking_ || brake_may_last_);
    stopped_ = braking_ = false;
  }
  judge_end_stops(reason);
  if (command_.brake) brake(0);
  if (command_.stop) reason = "a step after software's stop";
  if (emergency) reason = "a step in an emergency";
  if (command_.stop || emergency) stop();
  if (braking_ && brake_is_over()) {
    reason = "a brake that does not end";
    stop();
  }
  if (model_->moving == 0 || command_.feed_watchdog) {
    watchdog_deadline_ = watchdog_ == 0 ? never : now_ + watchdog_;
  } else if (now_ > watchdog_deadline_ + 2) {
    reason = "a step that the watchdog should have prevented";
  }
  command_ = {};
  return reason;
}

void WildProgram::judge_end_stops(const char*& reason) {
  const auto changed = static_cast<std::uint8_t>(model_->end_stops ^ inputs_.end_stops);
  const auto wanted =
      static_cast<std::uint8_t>(stop_on_.on_release ? ~model_->end_stops : model_->end_stops);
  const auto met =
      static_cast<std::uint8_t>(wanted & stop_on_.mask & (stop_on_.on_change ? changed : 0xFFu));
  began_brake_ &= static_cast<std::uint8_t>(~changed);
  const auto others = static_cast<std::uint8_t>(met & ~began_brake_);
  if (model_->moving != 0 && met != 0) {
    if (!stop_on_.brakes || (braking_ && others != 0)) {
      reason = "a step past an end stop";
      stop();
    } else {
      brake(met);
    }
  }
}

void WildProgram::stop() {
  if (!stopped_ && !braking_) {
    ++stops_;
    stop_begins_ = true;
    stop_clock_ = now_;
    stop_is_known_ = !brake_may_last_;
  }
  stopped_ = true;
}

void WildProgram::brake(std::uint8_t end_stops) {
  if (braking_ || stopped_) return;
  stop();
  stopped_ = false;
  braking_ = true;
  began_brake_ = end_stops;
  braked_clocks_ = 0;
}

// From a scale below 4; at its end the base may wait for a guard, to do the last base clock.
bool WildProgram::brake_is_over() {
  ++braked_clocks_;
  if (brake_slope_ == 0) return slope_age_ >= 4;
  constexpr std::uint64_t longest_guard = 4 * 4096;
  return braked_clocks_ > (std::uint64_t{4} << 32u) / brake_slope_ + longest_guard;
}

std::uint32_t WildProgram::access(std::uint32_t address, bool writes, std::uint32_t value,
                                  unsigned select) {
  model_->request_strobe = 1;
  model_->request_write = writes;
  model_->request_address = address;
  model_->request_select_bytes = static_cast<std::uint8_t>(select);
  model_->request_data = value;
  for (int i = 0; i < 4; ++i) {
    clock();
    if (model_->response_acknowledge != 0 || model_->response_error != 0) break;
  }
  refused_by_bus_ = model_->response_error != 0;
  expect((model_->response_acknowledge != 0) != refused_by_bus_, "an access gets one answer");
  const std::uint32_t data = model_->response_data;
  // In this clock a write acts.
  idle_when_written_ = model_->idle != 0;
  model_->request_strobe = 0;
  if (writes && !refused_by_bus_) note(address, value);
  clock();
  // What ends motion in this clock sees the position before.
  if (placed_) pins_.place(placed_axis_, *placed_);
  placed_.reset();
  return data;
}

void WildProgram::write(std::uint32_t address, std::uint32_t value) {
  if (address == reg::SegmentFlags::address) {
    auto flags = reg::SegmentFlags::decode(value);
    flags.stop_mask = stop_on_.mask;
    flags.stop_on_change = stop_on_.on_change;
    flags.stop_on_release = stop_on_.on_release;
    flags.stop_brakes = stop_on_.brakes;
    value = flags.encode();
  }
  access(address, true, value);
}

void WildProgram::note(std::uint32_t address, std::uint32_t value) {
  if (address == reg::Command::address) {
    note_command(reg::Command::decode(value));
  } else if (address == reg::Watchdog::address) {
    // A shorter limit is kept from its write on at the latest.
    watchdog_ = value;
    watchdog_deadline_ = value == 0 ? never : std::min(watchdog_deadline_, now_ + value);
  } else if (address == reg::BrakeSlope::address) {
    brake_slope_ = value;
    slope_age_ = 0;
    braked_clocks_ = 0;
  } else if (address >= reg::Position::address_of(0) &&
             address <= reg::Position::address_of(MotorPinWatch::axes - 1)) {
    if (idle_when_written_) {
      placed_axis_ = (address - reg::Position::address_of(0)) / 4;
      placed_ = static_cast<std::int32_t>(value);
    }
  } else {
    note_guard(address, value);
  }
}

void WildProgram::note_command(const reg::Command& command) {
  command_ = command;
  if (command.snapshot) {
    snapshot_ = pins_.positions();
    snapshot_clock_ = now_;
  }
}

// False where the hardware must refuse it.
bool WildProgram::note_guard(std::uint32_t address, std::uint32_t value) {
  const auto at_least_one = [](std::uint32_t clocks) { return std::max(clocks, 1u); };
  for (std::size_t axis = 0; axis < MotorPinWatch::axes; ++axis) {
    MotorPinWatch::Guard guard = pins_.guard(axis);
    if (address == reg::PulseGuard::address_of(axis)) {
      const auto wanted = reg::PulseGuard::decode(value);
      const bool is_high = (model_->step >> axis & 1u) != 0;
      if (!idle_when_written_ || (is_high && wanted.both_edges != guard.both_edges)) return false;
      guard.high = at_least_one(wanted.high);
      guard.low = at_least_one(wanted.low);
      guard.both_edges = wanted.both_edges;
    } else if (address == reg::DirectionGuard::address_of(axis)) {
      if (!idle_when_written_) return false;
      const auto wanted = reg::DirectionGuard::decode(value);
      guard.setup = at_least_one(wanted.setup);
      guard.hold = at_least_one(wanted.hold);
    } else {
      continue;
    }
    pins_.use(axis, guard);
  }
  return true;
}

void WildProgram::expect(bool holds, const char* claim) const {
  if (!holds) throw PinFault("clock " + std::to_string(now_) + ": not so: " + claim);
}

}  // namespace tests
