// SPDX-License-Identifier: Apache-2.0
// Sine, cosine, angles and equal parts against floating point.
#include "motion/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "motion/share.hpp"

namespace motion {
namespace {

constexpr double turn = 2 * std::numbers::pi;

TEST(rotation, is_cosine_and_sine) {
  std::mt19937 random(4);
  for (int i = 0; i < 200'000; ++i) {
    const auto angle = i < 64 ? static_cast<Angle>(i) << 26 : static_cast<Angle>(random());
    const Rotation rotation = rotation_by(angle);
    const double radians = angle * std::ldexp(turn, -32);
    ASSERT_NEAR(rotation.cosine, std::ldexp(std::cos(radians), 30), 2) << angle;
    ASSERT_NEAR(rotation.sine, std::ldexp(std::sin(radians), 30), 2) << angle;
  }
}

TEST(rotation, finds_the_angle_between_two_vectors) {
  std::mt19937 random(5);
  const auto component = [&] { return static_cast<std::int32_t>(random()) / 2 >> (random() % 30); };
  for (int i = 0; i < 200'000; ++i) {
    const Vector from{component(), component()}, to{component(), component()};
    if ((from[0] == 0 && from[1] == 0) || (to[0] == 0 && to[1] == 0)) continue;
    const Angle angle = angle_between(from, to);
    double radians = std::atan2(to[1], to[0]) - std::atan2(from[1], from[0]);
    radians -= turn * std::floor(radians / turn);
    double difference = radians - angle * std::ldexp(turn, -32);
    difference -= turn * std::round(difference / turn);
    ASSERT_NEAR(difference, 0, std::ldexp(1, -27))
        << from[0] << " " << from[1] << " " << to[0] << " " << to[1];
  }
  EXPECT_EQ(angle_between({0, 0}, {1, 1}), 0u);
  EXPECT_EQ(angle_between({1, 0}, {0, 1}), 1u << 30);
  EXPECT_EQ(angle_between({0, 1}, {0, -1}), 1u << 31);
}

TEST(share, covers_a_distance_in_equal_parts) {
  for (const std::int64_t total : {0LL, 1LL, -1LL, 1'000'003LL, -999'999'999'937LL}) {
    for (const std::uint32_t parts : {1u, 3u, 7u, 3142u}) {
      Share share(total, parts);
      for (std::uint32_t part = 1; part <= parts; ++part) {
        share.advance();
        const double exact = static_cast<double>(total) * part / parts;
        ASSERT_NEAR(static_cast<double>(share.covered()), exact, 1.0) << total << " " << parts;
      }
    }
  }
}

}  // namespace
}  // namespace motion
