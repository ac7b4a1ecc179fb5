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

// Not normalised: weights in 2^-30, delays in eighths of the damped period.
struct Form {
  std::array<std::uint32_t, 4> weights{};
  std::array<std::uint8_t, 4> eighths{};
  std::size_t count{};
};

// What is left of the vibration's amplitude after half a damped period is `half`, and after 3/8
// of one, `three_eighths`.
Form form_of(ShaperType type, std::uint32_t half, std::uint32_t three_eighths) {
  constexpr std::uint32_t mzv_first = 314'491'699;  // 1 - 1 / sqrt(2)
  constexpr std::uint32_t mzv_second = 444'758'426;  // sqrt(2) - 1
  constexpr std::uint32_t tolerance = one / 20;  // of EI and two-hump EI
  // (3 X^2 + 2 X + 3 V^2) / (16 X) with V = 1/20, X = (V^2 (sqrt(1 - V^2) + 1))^(1/3)
  constexpr std::uint32_t hump_first = 171'580'939;
  const std::uint32_t period = product(half, half);
  switch (type) {
    case ShaperType::none:
      break;
    case ShaperType::zv:
      return {{one, half}, {0, 4}, 2};
    case ShaperType::zvd:
      return {{one, 2 * half, period}, {0, 4, 8}, 3};
    case ShaperType::mzv:
      return {{mzv_first, product(mzv_second, three_eighths),
               product(mzv_first, product(three_eighths, three_eighths))},
              {0, 3, 6},
              3};
    case ShaperType::ei: {
      constexpr std::uint32_t first = (one + tolerance) / 4;
      return {{first, product((one - tolerance) / 2, half), product(first, period)}, {0, 4, 8}, 3};
    }
    case ShaperType::two_hump_ei: {
      constexpr std::uint32_t second = one / 2 - hump_first;
      return {{hump_first, product(second, half), product(second, period),
               product(hump_first, product(half, period))},
              {0, 4, 8, 12},
              4};
    }
  }
  return {{one}, {0}, 1};
}

}  // namespace

Impulses impulses_of(const Shaper& shaper, units::Hertz clock) {
  constexpr std::uint32_t pi = 3'373'259'426;  // 2^30 * pi
  Impulses result;
  Form form{{one}, {0}, 1};
  Scaled eighth;  // of the damped period, clocks
  if (shaper.type != ShaperType::none) {
    const Scaled damped = damped_part(shaper.damping);
    const Scaled exponent =
        Scaled::of(std::uint64_t{pi} * shaper.damping) / (Scaled::of(damping_one) * damped);
    const std::uint64_t half = exponent.floor();
    form = form_of(shaper.type, decay(half), decay(half / 4 * 3));
    eighth =
        Scaled::of(std::uint64_t{clock.count()} * 125) / (Scaled::of(shaper.millihertz) * damped);
  }
  std::uint64_t sum = 0;
  for (const std::uint32_t weight : form.weights) sum += weight;
  std::int32_t left = weight_one;
  std::uint64_t mean = 0;
  result.count = form.count;
  units::LoopBound<std::tuple_size_v<decltype(result.list)>> bound;
  for (std::size_t i = form.count; i-- > 0;) {
    bound.next();
    Impulse& impulse = result.list[i];
    const Scaled share = Scaled::of(form.weights[i]) / Scaled::of(sum);
    // The first one takes what rounding leaves.
    impulse.weight =
        i == 0 ? left : static_cast<std::int32_t>((share.floor(weight_fraction_bits + 1) + 1) / 2);
    left -= impulse.weight;
    impulse.delay = static_cast<std::uint32_t>((eighth * Scaled::of(form.eighths[i])).floor());
    mean += std::uint64_t{impulse.delay} * static_cast<std::uint32_t>(impulse.weight);
  }
  result.mean = static_cast<std::uint32_t>(mean >> weight_fraction_bits);
  return result;
}

}  // namespace motion
