// SPDX-License-Identifier: Apache-2.0
// Reference: the segment that software is writing, and whether it may be executed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace motion_reference {

inline constexpr std::size_t axes = 5;
inline constexpr std::size_t queue_depth = 32;

struct Segment {
  std::uint32_t backward{};
  std::uint32_t ahead{};
  std::uint32_t behind{};
  bool continues_line{};
  bool ends_motion{};
  bool waits_for_start{};
  std::uint32_t stop_mask{};
  bool stop_on_change{}, stop_on_release{}, stop_brakes{};
  std::uint64_t line_ticks{};
  std::uint64_t ticks{};
  std::uint64_t rate{};
  std::int64_t acceleration{};
  std::int64_t jerk{};
  std::array<std::uint64_t, axes> steps{};
};

enum class Refusal : std::uint8_t {
  queue_full = 1,
  incomplete = 2,
  illegal = 4,
  while_stopped = 8,
  disabled = 64
};

// Words may be written in any order, but the flags first, and line_ticks before ticks and steps.
class SegmentDraft {
 public:
  // A word at a register's address. `line_left`: ticks of the last line that no segment has yet.
  void write(std::uint32_t address, std::uint32_t value, std::uint64_t line_left);

  bool complete() const;
  // Only if complete.
  bool executable() const;
  Segment segment() const;
  void forget() { *this = SegmentDraft(); }

 private:
  void write_limited(std::optional<std::uint32_t>& word, std::uint32_t value, std::uint32_t least);

  std::optional<std::uint32_t> flags_, line_ticks_, ticks_;
  std::array<std::optional<std::uint32_t>, 6> course_;  // rate, acceleration, jerk: low, high
  std::array<std::optional<std::uint32_t>, axes> steps_;
  bool continues_line_ = false;
  std::optional<std::uint64_t> limit_;
  bool in_range_ = true;
};

}  // namespace motion_reference
