// SPDX-License-Identifier: Apache-2.0
// A ramp of third order: the acceleration rises from 0 and falls back to 0, each linearly in time.
#pragma once

#include <cstdint>
#include <optional>

#include "motion/scaled.hpp"
#include "motion/segment.hpp"

namespace motion {

// Whether the machine of this image has such ramps: a constant of its main.cpp, so that the linker
// leaves them out otherwise. On a host it is true, and Limits::s_curve decides.
extern const bool s_curve_in_image;

// With the rate a at the slow end, d more at the fast one, the time T, and the highest acceleration
// A at the part u of that time from the slow end (the apex):
//
//   A = 2 d / T                      twice the mean one, wherever the apex is
//   n = T (3 a + d (2 - u)) / 3      ticks in all
//   k = T (3 a u + d u^2) / 3        ticks on the slow side
//
// The ramp is two segments, so n and k are whole: k is what u = 1/2 gives, rounded up, and u
// follows from it. So rate and acceleration run on from one segment to the next, and the rates at
// both ends are exact. Rounded up makes T longer and A lower than u = 1/2 does.
class SCurve {
 public:
  // A ramp of less time or fewer ticks has to be one of constant acceleration: too short to keep a
  // machine from ringing, and its two segments too short for the queue.
  static constexpr std::uint64_t least_clocks = 32'000;
  static constexpr std::uint32_t least_ticks = 8;
  // So does one of more time: its jerk has too few digits.
  static constexpr std::uint64_t most_clocks = std::uint64_t{1} << 28;

  // Between two rates (in 2^-64 ticks per clock, at most 1/2) with A below 2^-21, as Geometry plans
  // it; none where the ramp has to be one of constant acceleration.
  static std::optional<SCurve> between(std::uint32_t ticks, std::uint64_t from, std::uint64_t to);
  // One of which the apex is known. The rates are different.
  SCurve(std::uint32_t ticks, std::uint64_t from, std::uint64_t to, std::uint32_t apex);

  std::uint32_t apex() const { return apex_; }  // u in 2^-32, from 1/2 to 1
  std::uint64_t clocks() const;  // T

  // The ticks and the course of one half, but for what belongs to the line.
  void set_half(bool second, Segment& segment) const;

 private:
  std::uint32_t slow_ticks() const;
  std::uint32_t apex_of_slow_ticks() const;
  Scaled three_means() const;

  std::uint32_t ticks_;
  std::uint32_t apex_;
  bool rises_;
  std::uint64_t from_;
  std::uint64_t slow_;  // a, in 2^-64
  Scaled change_;  // d, in 2^-64
};

}  // namespace motion
