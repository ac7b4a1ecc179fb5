// SPDX-License-Identifier: Apache-2.0
// Input shapers and linear advance as a file sets them, and by how much they may change the motion.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace report {

enum class ShaperKind : std::uint8_t { none, zv, zvd, mzv, ei, two_hump_ei };
// By its name in M593 P, in either case; empty for another text.
std::optional<ShaperKind> shaper_named(std::string_view name);

struct ShaperSetting {
  ShaperKind kind{};
  std::int64_t millihertz{};
  std::int64_t damping = 1000;  // ratio in 10^-4

  bool operator==(const ShaperSetting&) const = default;
};

struct ShapingSetting {
  std::array<ShaperSetting, 2> shapers{};  // of the motors of X and Y
  std::int64_t advance_us{};

  bool operator==(const ShapingSetting&) const = default;
  bool any() const;
};

// A shaper is a sum of delayed motions; these are times of its impulses.
struct ShaperTimes {
  std::size_t impulses = 1;
  double length_s{};  // from the first to the last
  double deviation_s{};  // mean absolute deviation from their mean
};
ShaperTimes times_of(const ShaperSetting& setting);

}  // namespace report
