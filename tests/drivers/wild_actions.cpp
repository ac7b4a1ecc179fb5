// SPDX-License-Identifier: Apache-2.0
// Actions of the random program: whole segments, invalid writes, and reads of known values.
#include <algorithm>

#include "tests/drivers/wild_program.hpp"

namespace tests {

namespace reg = registers::step_generator;

constexpr std::size_t axes = MotorPinWatch::axes;

std::uint32_t WildProgram::any_word() {
  switch (below(6)) {
    case 0:
      return 0;
    case 1:
      return ~0u;
    case 2:
      return below(64);
    case 3:
      return 1u << below(32);
    case 4:
      return (1u << 31) - 1 + below(3);
    default:
      return word();
  }
}

// High words: mostly quick.
std::uint32_t WildProgram::any_rate() { return chance(6) ? any_word() : (1u << 31) >> below(8); }

void WildProgram::append_segment() {
  const bool continues = chance(4);
  write(reg::SegmentFlags::address, (word() & ~(1u << 8)) | (continues ? 1u << 8 : 0));
  if (chance(3)) {
    // No axis is both ahead and behind.
    write(reg::SegmentFlags::address,
          (word() & 0x0FFF'FEFF & ~(chance(8) ? 0 : 1u << 13)) | (continues ? 1u << 8 : 0));
  }
  line_ticks_ = continues ? line_ticks_ : 1 + below(chance(4) ? 400 : 20);
  const std::uint32_t limit = std::max(line_ticks_, 1u);
  write(reg::SegmentLineTicks::address, limit);
  const std::uint32_t ticks = chance(3) ? 1 + below(limit) : limit;
  write(reg::SegmentTicks::address, ticks);
  line_ticks_ -= std::min(line_ticks_, ticks);
  write(reg::SegmentRateLow::address, 0);
  write(reg::SegmentRateHigh::address, any_rate());
  const bool is_ramp = chance(3);
  const std::uint32_t sign = chance(2) ? ~0u : 0;
  write(reg::SegmentAccelerationLow::address, is_ramp ? word() : 0);
  write(reg::SegmentAccelerationHigh::address, !is_ramp    ? 0
                                               : chance(6) ? any_word()
                                                           : sign ^ (word() >> (4 + below(12))));
  const bool is_curve = chance(6);
  write(reg::SegmentJerkLow::address, is_curve ? word() : 0);
  write(reg::SegmentJerkHigh::address, is_curve && chance(2) ? any_word() : 0);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    write(reg::SegmentSteps::address_of(axis), chance(3) ? limit : below(limit + 1));
  }
  if (chance(40)) return;
  const auto queued = [this] { return reg::Status::decode(read(reg::Status::address)).level; };
  const bool must_be_refused = stopped_ || braking_;
  const std::uint32_t before = must_be_refused ? queued() : 0;
  write(reg::SegmentCommit::address, word());
  if (must_be_refused && (stopped_ || braking_)) {
    expect(queued() <= before, "nothing is queued between stop and acknowledgement");
  }
}

// A bus error, without any visible effect.
void WildProgram::write_part_of_a_word() {
  const std::uint32_t address = reg::base + 4 * below(0x160 / 4);
  access(address + below(4), true, any_word(), below(15));
  expect(refused_by_bus_, "a part of a word is a bus error");
}

void WildProgram::write_guard() {
  const std::size_t axis = below(axes);
  write(reg::Command::address, reg::Command{.clear_errors = true}.encode());
  const std::uint32_t longest = chance(5) ? 60 : 4;
  const std::uint32_t first = below(longest), second = below(longest);
  const bool pulse = chance(2);
  const std::uint32_t value =
      pulse ? reg::PulseGuard{.high = first, .low = second, .both_edges = chance(2)}.encode()
            : reg::DirectionGuard{.setup = first, .hold = second}.encode();
  const auto before = pins_.guard(axis);
  const bool was_high = (model_->step >> axis & 1u) != 0;
  const std::uint32_t address =
      pulse ? reg::PulseGuard::address_of(axis) : reg::DirectionGuard::address_of(axis);
  write(address, value);
  const bool changes_edges =
      pulse && reg::PulseGuard::decode(value).both_edges != before.both_edges;
  const bool accepted = idle_when_written_ && !(was_high && changes_edges);
  const bool refused = reg::Errors::decode(read(reg::Errors::address)).settings;
  expect(refused == !accepted, "a guard is refused exactly where it may not change");
}

void WildProgram::write_position() {
  write(reg::Command::address, reg::Command{.clear_errors = true}.encode());
  const std::size_t axis = below(axes);
  write(reg::Position::address_of(axis), any_word());
  const bool accepted = idle_when_written_;
  expect(reg::Errors::decode(read(reg::Errors::address)).position == !accepted,
         "a position is refused exactly where it may not change");
}

void WildProgram::compare_snapshot() {
  write(reg::Command::address, reg::Command{.snapshot = true}.encode());
  const auto expected = snapshot_;
  const std::uint64_t clock = snapshot_clock_;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const auto steps = static_cast<std::int32_t>(read(reg::SnapshotPosition::address_of(axis)));
    expect(steps == expected[axis], "a snapshot has all positions of one clock");
  }
  const std::uint64_t low = read(reg::SnapshotTimeLow::address);
  const std::uint64_t time = std::uint64_t{read(reg::SnapshotTimeHigh::address)} << 32u | low;
  if (clock_offset_ == 0) clock_offset_ = clock - time;
  expect(clock - time == clock_offset_, "a snapshot has the time of its positions");
}

void WildProgram::compare_stop() {
  clock(2);
  const bool is_stopped = stopped_ && stop_is_known_;
  clock(2);
  const auto status = reg::Status::decode(read(reg::Status::address));
  if (is_stopped && stopped_) {
    expect(status.stopped, "what has stopped motion is a stop");
    expect(status.level == 0 && !status.moving, "a stop leaves nothing queued");
  }
  const bool by_watchdog = reg::StopCause::decode(read(reg::StopCause::address)).watchdog;
  if (!status.stopped || !stopped_ || !stop_is_known_ || by_watchdog || clock_offset_ == 0) return;
  const std::uint64_t clock = stop_clock_;
  const auto expected = stop_positions_;
  bool equal = true;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const auto steps = static_cast<std::int32_t>(read(reg::StopPosition::address_of(axis)));
    equal = equal && steps == expected[axis];
  }
  const std::uint64_t low = read(reg::StopTimeLow::address);
  const std::uint64_t time = std::uint64_t{read(reg::StopTimeHigh::address)} << 32u | low;
  if (stop_clock_ != clock) {
    return;  // another one meanwhile
  }
  expect(equal, "a stop has the positions of its clock");
  expect(clock - time == clock_offset_, "a stop has its time");
  ++latches_compared_;
}

void WildProgram::switch_motors() {
  write(reg::MotorEnable::address, chance(5) ? any_word() : 0b11111);
}

void WildProgram::act() {
  switch (below(20)) {
    case 0:
    case 1:
      write(reg::base + 4 * below(0x160 / 4), any_word());
      return;
    case 2:
      write(reg::Command::address, chance(3) ? word() & ~0x3u : 1u << below(9));
      return;
    case 3:
      return write_part_of_a_word();
    case 4:
      return write_guard();
    case 5:
      return write_position();
    case 6:
      return compare_snapshot();
    case 7:
      return compare_stop();
    case 8:
      return switch_motors();
    case 9:
      write(reg::Control::address, reg::Control{.run = !chance(8)}.encode());
      return;
    case 10:
      write(reg::RateFloor::address, chance(3) ? any_word() : 1u << (20 + below(11)));
      return;
    case 11:
      write(reg::Override::address, chance(2) ? 65536 : below(1u << 18));
      return;
    case 12:
      write(chance(2) ? reg::OverrideSlope::address : reg::BrakeSlope::address, any_slope());
      return;
    case 13:
      write(reg::Watchdog::address, chance(2) ? 0 : below(800));
      return;
    case 14: {
      if (model_->emergency_stop != 0) clock(below(30));
      write(reg::Command::address, reg::Command{.acknowledge_stop = true}.encode());
      switch_motors();
      return;
    }
    default:
      append_segment();
  }
}

void WildProgram::come_to_rest() {
  const bool halts = !chance(3);
  write(reg::Command::address, reg::Command{.stop = halts, .snapshot = true}.encode());
  clock(3);
  compare_stop();
  compare_snapshot();
}

void WildProgram::run(int actions) {
  write(reg::RateFloor::address, 1u << 26);
  for (int i = 0; i < actions; ++i) {
    act();
    clock(chance(8) ? below(300) : below(12));
  }
  come_to_rest();
}

}  // namespace tests
