// SPDX-License-Identifier: Apache-2.0
// The impulses of the shapers against the formulas of the literature, and against what they are
// for: the vibration that a damped mode has left after them.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "motion/shaper.hpp"

namespace motion_test {
namespace {

using motion::ShaperType;

constexpr units::Hertz clock_rate{50'000'000};

struct ExactImpulse {
  double weight, seconds;
};

// Singer and Seering 1990 (ZV, ZVD), Singhose 1994 (EI), Klipper's shaper_defs.py (MZV, two-hump
// EI, and EI for a damped mode).
std::vector<ExactImpulse> exact(const motion::Shaper& shaper) {
  const double damping = shaper.damping / 1e4;
  const double root = std::sqrt(1 - damping * damping);
  const double period = 1e3 / shaper.millihertz / root;
  const double k = std::exp(-damping * std::numbers::pi / root);
  const double v = 0.05;
  std::vector<ExactImpulse> list;
  switch (shaper.type) {
    case ShaperType::none:
      return {{1, 0}};
    case ShaperType::zv:
      list = {{1, 0}, {k, period / 2}};
      break;
    case ShaperType::zvd:
      list = {{1, 0}, {2 * k, period / 2}, {k * k, period}};
      break;
    case ShaperType::mzv: {
      const double m = std::exp(-0.75 * damping * std::numbers::pi / root);
      const double first = 1 - 1 / std::numbers::sqrt2;
      list = {{first, 0},
              {(std::numbers::sqrt2 - 1) * m, 0.375 * period},
              {first * m * m, 0.75 * period}};
      break;
    }
    case ShaperType::ei:
      list = {{(1 + v) / 4, 0}, {(1 - v) / 2 * k, period / 2}, {(1 + v) / 4 * k * k, period}};
      break;
    case ShaperType::two_hump_ei: {
      const double x = std::cbrt(v * v * (std::sqrt(1 - v * v) + 1));
      const double first = (3 * x * x + 2 * x + 3 * v * v) / (16 * x);
      list = {{first, 0},
              {(0.5 - first) * k, period / 2},
              {(0.5 - first) * k * k, period},
              {first * k * k * k, 1.5 * period}};
      break;
    }
  }
  double sum = 0;
  for (const ExactImpulse& impulse : list) sum += impulse.weight;
  for (ExactImpulse& impulse : list) impulse.weight /= sum;
  return list;
}

// What is left of a mode's vibration after the last impulse, in parts of what one impulse leaves.
double vibration_left(const motion::Impulses& impulses, double hertz, double damping) {
  const double angular = 2 * std::numbers::pi * hertz;
  const std::complex<double> pole{damping * angular, angular * std::sqrt(1 - damping * damping)};
  std::complex<double> sum = 0;
  const double last = impulses.list[impulses.count - 1].delay / 50e6;
  for (std::size_t i = 0; i < impulses.count; ++i) {
    const motion::Impulse& impulse = impulses.list[i];
    sum += impulse.weight / std::ldexp(1, motion::weight_fraction_bits) *
           std::exp(pole * (impulse.delay / 50e6));
  }
  return std::abs(sum) * std::exp(-damping * angular * last);
}

motion::Shaper random_shaper(std::mt19937& random, std::uint32_t most_damping) {
  return {.type = static_cast<ShaperType>(1 + random() % (motion::shaper_type_count - 1)),
          .millihertz = static_cast<std::uint32_t>(5'000 + random() % 200'000),
          .damping = static_cast<std::uint32_t>(random() % (most_damping + 1))};
}

TEST(shaper, has_the_impulses_of_the_literature) {
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    const motion::Shaper shaper = random_shaper(random, motion::most_damping);
    const auto expected = exact(shaper);
    const motion::Impulses made = motion::impulses_of(shaper, clock_rate);
    ASSERT_EQ(made.count, expected.size());
    std::int64_t sum = 0;
    double mean = 0;
    for (std::size_t i = 0; i < made.count; ++i) {
      const double weight = std::ldexp(made.list[i].weight, -motion::weight_fraction_bits);
      EXPECT_NEAR(weight, expected[i].weight, 4e-6);
      EXPECT_NEAR(made.list[i].delay, expected[i].seconds * 50e6, 4);
      sum += made.list[i].weight;
      mean += expected[i].weight * expected[i].seconds * 50e6;
    }
    EXPECT_EQ(sum, motion::weight_one);
    EXPECT_NEAR(made.mean, mean, 100);
  }
}

TEST(shaper, leaves_no_vibration_of_its_mode) {
  std::mt19937 random(2);
  for (int round = 0; round < 3000; ++round) {
    const motion::Shaper shaper = random_shaper(random, 2000);
    const double left = vibration_left(motion::impulses_of(shaper, clock_rate),
                                       shaper.millihertz / 1e3, shaper.damping / 1e4);
    const bool tolerates = shaper.type == ShaperType::ei || shaper.type == ShaperType::two_hump_ei;
    EXPECT_LE(left, tolerates ? 0.0505 : 2e-5) << static_cast<int>(shaper.type);
  }
}

// What the more elaborate shapers are longer for: the mode may be off by so much.
TEST(shaper, tolerates_an_error_of_the_frequency) {
  const auto left = [](ShaperType type, double factor) {
    const motion::Shaper shaper{.type = type, .millihertz = 40'000, .damping = 0};
    return vibration_left(motion::impulses_of(shaper, clock_rate), 40.0 * factor, 0);
  };
  for (const double factor : {0.9, 1.1}) {
    EXPECT_GT(left(ShaperType::zv, factor), 0.1);
    EXPECT_LT(left(ShaperType::zvd, factor), 0.05);
    EXPECT_LT(left(ShaperType::ei, factor), 0.051);
    EXPECT_LT(left(ShaperType::two_hump_ei, factor), 0.051);
  }
  EXPECT_GT(left(ShaperType::ei, 0.75), 0.1);
  EXPECT_LT(left(ShaperType::two_hump_ei, 0.75), 0.051);
}

}  // namespace
}  // namespace motion_test
