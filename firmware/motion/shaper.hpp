// SPDX-License-Identifier: Apache-2.0
// Input shapers: impulses that, convolved with a motion, leave no vibration of one mode behind.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "units/quantity.hpp"

namespace motion {

// ZV and ZVD: N. C. Singer, W. P. Seering, "Preshaping command inputs to reduce system vibration",
// 1990. EI and two-hump EI, with 5 % of the vibration left at most within their band: W. Singhose,
// W. Seering, N. Singer, "Residual vibration reduction using vector diagrams", 1994. MZV, and the
// forms for a damped mode: Klipper's extras/shaper_defs.py.
enum class ShaperType : std::uint8_t { none, zv, zvd, mzv, ei, two_hump_ei };
inline constexpr std::size_t shaper_type_count = 6;
// As M593 P and the machine description write them, in the order of the type.
inline constexpr std::array<std::string_view, shaper_type_count> shaper_names{
    "none", "zv", "zvd", "mzv", "ei", "2hump_ei"};

struct Shaper {
  ShaperType type{};
  std::uint32_t millihertz{};  // of the damped mode's undamped frequency, least .. most_millihertz
  std::uint32_t damping{1000};  // ratio in 10^-4, 0 .. most_damping

  bool operator==(const Shaper&) const = default;
};

inline constexpr std::uint32_t least_millihertz = 5'000;
inline constexpr std::uint32_t most_millihertz = 500'000;
inline constexpr std::uint32_t damping_one = 10'000;
inline constexpr std::uint32_t most_damping = 9'000;

// Weights are in 2^-20; those of a shaper are positive and sum up to 1 exactly.
inline constexpr int weight_fraction_bits = 20;
inline constexpr std::int32_t weight_one = 1 << weight_fraction_bits;

struct Impulse {
  std::int32_t weight{};
  std::uint32_t delay{};  // clocks
};

inline constexpr std::size_t most_impulses = 4;
struct Impulses {
  std::array<Impulse, most_impulses> list{};
  std::size_t count{};
  std::uint32_t mean{};  // clocks: the delay of a motion at constant speed
};

// Without a type one impulse at 0. Delays are exact to some clocks, weights to 2^-19.
Impulses impulses_of(const Shaper& shaper, units::Hertz clock);

}  // namespace motion
