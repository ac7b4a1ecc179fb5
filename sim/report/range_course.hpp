// SPDX-License-Identifier: Apache-2.0
// A quantity over the whole print in bounded memory, with all its peaks.
#pragma once

#include <cstddef>
#include <vector>

namespace report {

struct Range {
  float low{};
  float high{};
};

// Samples at a fixed period, gathered in buckets of equal length with the lowest and the highest
// of each. When there are too many buckets, each two become one.
class RangeCourse {
 public:
  static constexpr std::size_t most_buckets = 8192;

  RangeCourse() = default;
  explicit RangeCourse(double period_seconds) : bucket_seconds_(period_seconds) {}

  void put(double value);

  double bucket_seconds() const { return bucket_seconds_; }
  const std::vector<Range>& buckets() const { return buckets_; }

 private:
  void merge_pairs();

  double bucket_seconds_ = 1.0;
  std::size_t samples_per_bucket_ = 1;
  std::size_t samples_in_last_ = 0;
  std::vector<Range> buckets_;
};

}  // namespace report
