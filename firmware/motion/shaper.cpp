// SPDX-License-Identifier: Apache-2.0
// The closed formulas of the shapers, in fixed point.
#include "motion/shaper.hpp"

#include <tuple>

#include "motion/scaled.hpp"
#include "units/loop_bound.hpp"

namespace motion {

namespace {

constexpr int fraction_bits = 30;
constexpr std::uint32_t one = 1u << fraction_bits;

std::uint32_t product(std::uint32_t first, std::uint32_t second) {
  return static_cast<std::uint32_t>(std::uint64_t{first} * second >> fraction_bits);
}

// e^-x for x < 8, both in 2^-30: Horner's form of the series of x / 16, squared four times.
std::uint32_t decay(std::uint64_t x) {
  constexpr int halvings = 4;
  const auto part = static_cast<std::uint32_t>(x >> halvings);
  std::uint32_t result = one;
  for (std::uint32_t n = 10; n > 0; --n) result = one - product(part, result) / n;
  for (int i = 0; i < halvings; ++i) result = product(result, result);
  return result;
}

// sqrt(1 - damping^2)
Scaled damped_part(std::uint32_t damping) {
  const std::uint32_t square = damping_one * damping_one - damping * damping;
  return Scaled::of(square).square_root() / Scaled::of(damping_one);
}

// Impulses are `eighths` of the damped period apart. Their weights, of an undamped mode and in
// 2^-30, fall by what the vibration decays from each to the next; they are not normalised.
struct Form {
  std::uint8_t count;
  std::uint8_t eighths;
  std::array<std::uint32_t, most_impulses> weights;
};

constexpr std::uint32_t tolerance = one / 20;  // V of EI and two-hump EI
constexpr std::uint32_t mzv_first = 314'491'699;  // 1 - 1 / sqrt(2)
constexpr std::uint32_t mzv_second = 444'758'426;  // sqrt(2) - 1
constexpr std::uint32_t ei_first = (one + tolerance) / 4;
constexpr std::uint32_t ei_second = (one - tolerance) / 2;
// (3 X^2 + 2 X + 3 V^2) / (16 X) with X = (V^2 (sqrt(1 - V^2) + 1))^(1/3)
constexpr std::uint32_t hump_first = 171'580'939;
constexpr std::uint32_t hump_second = one / 2 - hump_first;

constexpr std::array<Form, shaper_type_count> forms{
    {{1, 0, {one}},
     {2, 4, {one, one}},
     {3, 4, {one / 2, one, one / 2}},
     {3, 3, {mzv_first, mzv_second, mzv_first}},
     {3, 4, {ei_first, ei_second, ei_first}},
     {4, 4, {hump_first, hump_second, hump_second, hump_first}}}};

}  // namespace

Impulses impulses_of(const Shaper& shaper, units::Hertz clock) {
  constexpr std::uint32_t pi = 3'373'259'426;  // 2^30 * pi
  const Form& form = forms[static_cast<std::size_t>(shaper.type)];
  std::uint32_t fall = one;
  Scaled interval;  // clocks
  if (form.eighths != 0) {
    const Scaled damped = damped_part(shaper.damping);
    const Scaled eighths = Scaled::of(form.eighths);
    const Scaled angle = Scaled::of(pi, -2) * eighths;
    fall = decay((angle * Scaled::of(shaper.damping) / (Scaled::of(damping_one) * damped)).floor());
    interval = Scaled::of(std::uint64_t{clock.count()} * 125) * eighths /
               (Scaled::of(shaper.millihertz) * damped);
  }
  std::array<std::uint32_t, most_impulses> weights{};
  std::uint64_t sum = 0;
  std::uint32_t decayed = one;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = product(form.weights[i], decayed);
    sum += weights[i];
    decayed = product(decayed, fall);
  }
  Impulses result;
  result.count = form.count;
  std::int32_t left = weight_one;
  std::uint64_t mean = 0;
  units::LoopBound<most_impulses> impulses;
  for (std::uint32_t i = form.count; i-- > 0;) {
    impulses.next();
    Impulse& impulse = result.list[i];
    // The first one takes what rounding leaves.
    impulse.weight =
        i == 0 ? left
               : static_cast<std::int32_t>(
                     (Scaled::of(weights[i]) / Scaled::of(sum)).floor(weight_fraction_bits));
    left -= impulse.weight;
    impulse.delay = static_cast<std::uint32_t>((interval * Scaled::of(i)).floor());
    mean += std::uint64_t{impulse.delay} * static_cast<std::uint32_t>(impulse.weight);
  }
  result.mean = static_cast<std::uint32_t>(mean >> weight_fraction_bits);
  return result;
}

}  // namespace motion
