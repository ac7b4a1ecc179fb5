// SPDX-License-Identifier: Apache-2.0
// Reference: the rules for the words of a segment, as the register description states them.
#include "tests/motion_reference/segment_draft.hpp"

#include <algorithm>

#include "registers/step_generator_registers.hpp"

namespace motion_reference {
namespace {

namespace registers = ::registers::step_generator;

constexpr std::uint32_t most_line_ticks = 0x7FFF'FFFFu;
constexpr std::uint64_t half = std::uint64_t{1} << 63u;
// The six words that are written one after the other from segment_rate_low on.
constexpr std::size_t rate_low = 0, rate_high = 1, acceleration_low = 2, jerk_low = 4;

std::uint64_t joined(const auto& words, std::size_t low) {
  return std::uint64_t{words[low + 1].value_or(0)} << 32u | words[low].value_or(0);
}

}  // namespace

void SegmentDraft::write_limited(std::optional<std::uint32_t>& word, std::uint32_t value,
                                 std::uint32_t least) {
  word.reset();
  if (!limit_) return;
  word = value;
  if (value < least || value > *limit_) in_range_ = false;
}

void SegmentDraft::write(std::uint32_t address, std::uint32_t value, std::uint64_t line_left) {
  if (address == registers::SegmentFlags::address) {
    forget();
    flags_ = value;
    const auto flags = registers::SegmentFlags::decode(value);
    continues_line_ = flags.continues_line;
    if (continues_line_) {
      limit_ = line_left;
    } else if ((flags.ahead & flags.behind) != 0) {
      in_range_ = false;
    }
  } else if (address == registers::SegmentLineTicks::address) {
    if (continues_line_) return;
    line_ticks_ = value;
    ticks_.reset();
    steps_.fill(std::nullopt);
    limit_ = value & most_line_ticks;
    if (value == 0 || value > most_line_ticks) in_range_ = false;
  } else if (address == registers::SegmentTicks::address) {
    write_limited(ticks_, value, 1);
  } else if (address >= registers::SegmentRateLow::address &&
             address <= registers::SegmentJerkHigh::address) {
    const std::size_t word = (address - registers::SegmentRateLow::address) / 4;
    course_[word] = value;
    if (word == rate_high && value > half >> 32u) in_range_ = false;
  } else {
    const std::size_t axis = (address - registers::SegmentSteps::address_of(0)) / 4;
    if (axis < axes && !continues_line_) write_limited(steps_[axis], value, 0);
  }
}

bool SegmentDraft::complete() const {
  const auto written = [](const auto& word) { return word.has_value(); };
  const bool line =
      continues_line_ || (line_ticks_.has_value() && std::ranges::all_of(steps_, written));
  return flags_.has_value() && ticks_.has_value() && std::ranges::all_of(course_, written) && line;
}

bool SegmentDraft::executable() const { return in_range_ && joined(course_, rate_low) <= half; }

Segment SegmentDraft::segment() const {
  const auto flags = registers::SegmentFlags::decode(flags_.value_or(0));
  Segment result{.backward = flags.backward,
                 .ahead = flags.ahead,
                 .behind = flags.behind,
                 .continues_line = flags.continues_line,
                 .ends_motion = flags.ends_motion,
                 .waits_for_start = flags.waits_for_start,
                 .stop_mask = flags.stop_mask,
                 .stop_on_change = flags.stop_on_change,
                 .stop_on_release = flags.stop_on_release,
                 .stop_brakes = flags.stop_brakes,
                 .line_ticks = line_ticks_.value_or(0),
                 .ticks = ticks_.value_or(0),
                 .rate = joined(course_, rate_low),
                 .acceleration = static_cast<std::int64_t>(joined(course_, acceleration_low)),
                 .jerk = static_cast<std::int64_t>(joined(course_, jerk_low)),
                 .steps = {}};
  for (std::size_t axis = 0; axis < axes; ++axis) result.steps[axis] = steps_[axis].value_or(0);
  return result;
}

}  // namespace motion_reference
