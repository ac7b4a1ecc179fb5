// SPDX-License-Identifier: Apache-2.0
// The image's 64-bit division against the host's, over random numbers of every length and
// all edges.
#include "platform/division.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

TEST(division, agrees_with_the_host_for_numbers_of_every_length) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2'000'000; ++i) {
    const std::uint64_t dividend = random() >> (random() % 64);
    const std::uint64_t divisor = (random() >> (random() % 64)) | 1u;
    ASSERT_EQ(platform::divide(dividend, divisor), dividend / divisor)
        << dividend << " / " << divisor;
  }
}

TEST(division, agrees_with_the_host_at_the_edges) {
  for (unsigned a = 0; a < 64; ++a) {
    for (unsigned b = 0; b < 64; ++b) {
      for (int difference = -2; difference <= 2; ++difference) {
        const std::uint64_t dividend =
            (std::uint64_t{1} << a) + static_cast<std::uint64_t>(difference);
        for (int other = -2; other <= 2; ++other) {
          const std::uint64_t divisor = (std::uint64_t{1} << b) + static_cast<std::uint64_t>(other);
          if (divisor == 0) continue;
          ASSERT_EQ(platform::divide(dividend, divisor), dividend / divisor)
              << dividend << " / " << divisor;
        }
      }
    }
  }
}

}  // namespace
