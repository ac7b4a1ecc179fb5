// SPDX-License-Identifier: Apache-2.0
// Scaled numbers against exact or long arithmetic.
#include "motion/scaled.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace {

using motion::Scaled;

constexpr long double allowed = 0x1p-31L;

long double value_of(Scaled number) {
  for (int scale = -64;; ++scale) {
    const std::uint64_t floor = number.floor(scale);
    if (floor >> 32 != 0) return std::ldexp(static_cast<long double>(floor), -scale);
    if (scale == 256) return static_cast<long double>(floor);
  }
}

void expect_truncated(Scaled result, long double exact) {
  const long double error = (exact - value_of(result)) / exact;
  EXPECT_LT(error, allowed);
  EXPECT_GT(error, -0x1p-60L);
}

std::uint64_t any(std::mt19937_64& random) { return (random() >> (random() % 63)) | 1; }

TEST(scaled, agrees_with_long_arithmetic_on_random_numbers) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300'000; ++i) {
    const Scaled left = Scaled::of(any(random));
    const Scaled right = Scaled::of(any(random));
    expect_truncated(left * right, value_of(left) * value_of(right));
    expect_truncated(left / right, value_of(left) / value_of(right));
    expect_truncated(left + right, value_of(left) + value_of(right));
    expect_truncated(left.square_root(), std::sqrt(value_of(left)));
    ASSERT_EQ(left < right, value_of(left) < value_of(right));
    ASSERT_FALSE(HasFailure());
  }
}

TEST(scaled, agrees_at_the_edges_of_its_digits) {
  for (const std::uint64_t a : {0x80000000u, 0x80000001u, 0x8000FFFFu, 0xFFFF0000u, 0xFFFFFFFFu}) {
    for (const std::uint64_t b :
         {0x80000000u, 0x80000001u, 0x8000FFFFu, 0xFFFF0000u, 0xFFFFFFFFu}) {
      const long double exact = static_cast<long double>(a) / static_cast<long double>(b);
      expect_truncated(Scaled::of(a) / Scaled::of(b), exact);
    }
    expect_truncated(Scaled::of(a).square_root(), std::sqrt(static_cast<long double>(a)));
    expect_truncated(Scaled::of(a, 1).square_root(), std::sqrt(2 * static_cast<long double>(a)));
  }
}

TEST(scaled, takes_the_exact_root_of_squares) {
  for (std::uint64_t root = 1; root < 200'000; root += 7) {
    if (root * root >> 32 != 0) break;
    ASSERT_EQ(Scaled::of(root * root).square_root().floor(), root);
  }
}

TEST(scaled, gives_integer_parts_at_any_scale) {
  EXPECT_EQ(Scaled::of(7).floor(), 7u);
  EXPECT_EQ(Scaled::of(7, -1).floor(), 3u);
  EXPECT_EQ(Scaled::of(7, -1).floor(1), 7u);
  EXPECT_EQ(Scaled::of(7, -200).floor(), 0u);
  EXPECT_EQ(Scaled::of(7, 200).floor(), ~std::uint64_t{0});
  EXPECT_EQ(Scaled::of(0).floor(64), 0u);
  EXPECT_EQ(Scaled::of(0xFFFF'FFFF, 32).floor(), 0xFFFF'FFFF'0000'0000u);
  EXPECT_LT(Scaled(), Scaled::of(1, -300));
}

}  // namespace
