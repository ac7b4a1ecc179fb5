// SPDX-License-Identifier: Apache-2.0
// Reference: base clocks are owed by the scale, and done as the longest leap that rate and debt
// permit; the scale follows its target within what the acceleration of the base leaves it.
#include "tests/motion_reference/pace.hpp"

#include <algorithm>

namespace motion_reference {
namespace {

constexpr std::uint64_t rate_for_fours = std::uint64_t{7} << 58u;
constexpr std::uint64_t rate_for_twos = std::uint64_t{15} << 58u;
constexpr std::uint64_t most_kept = 3;

std::uint64_t longest_leap(std::uint64_t rate) {
  if (rate < rate_for_fours) return 4;
  return rate < rate_for_twos ? 2 : 1;
}

}  // namespace

void Pace::clock(bool moving, bool braking, bool stalled, std::int64_t acceleration,
                 std::uint64_t rate) {
  const bool stands = scale_ == 0 && leap_ == 0;
  if (!stalled) share_out(moving, rate);
  const std::uint64_t goal = braking ? 0 : target;
  if (moving) {
    approach(goal, braking ? brake_slope : permitted_slope(acceleration));
  } else {
    scale_ = goal;
  }
  standing_ = stands;
}

void Pace::share_out(bool moving, std::uint64_t rate) {
  // Motion from rest owes nothing from before.
  if (!moving) owed_ = 0;
  owed_ += scale_;
  const std::uint64_t most = std::min(owed_ / one, longest_leap(rate));
  leap_ = most == 3 ? 2 : most;
  owed_ -= leap_ * one;
  const std::uint64_t whole = std::min(owed_ / one, most_kept);
  owed_ = whole * one + owed_ % one;
}

std::uint64_t Pace::permitted_slope(std::int64_t acceleration) const {
  const bool same_side = scale_ < target ? acceleration > 0 : acceleration < 0;
  if (!same_side) return slope;
  if (scale_ * 2 < one) return slope / 2;
  if (scale_ * 4 < 3 * one) return slope / 4;
  if (scale_ * 8 < 7 * one) return slope / 8;
  return 0;
}

void Pace::approach(std::uint64_t goal, std::uint64_t change) {
  if (scale_ < goal) {
    scale_ = std::min(goal, scale_ + change);
  } else {
    scale_ = scale_ - goal > change ? scale_ - change : goal;
  }
}

}  // namespace motion_reference
