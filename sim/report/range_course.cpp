// SPDX-License-Identifier: Apache-2.0
// Filling and merging of buckets.
#include "sim/report/range_course.hpp"

#include <algorithm>

namespace report {

void RangeCourse::put(double value) {
  const auto sample = static_cast<float>(value);
  if (!buckets_.empty() && samples_in_last_ < samples_per_bucket_) {
    Range& last = buckets_.back();
    last.low = std::min(last.low, sample);
    last.high = std::max(last.high, sample);
    ++samples_in_last_;
    return;
  }
  if (buckets_.size() == most_buckets) merge_pairs();
  buckets_.push_back({sample, sample});
  samples_in_last_ = 1;
}

void RangeCourse::merge_pairs() {
  for (std::size_t i = 0; i < buckets_.size() / 2; ++i) {
    const Range &first = buckets_[2 * i], &second = buckets_[2 * i + 1];
    buckets_[i] = {std::min(first.low, second.low), std::max(first.high, second.high)};
  }
  buckets_.resize(buckets_.size() / 2);
  samples_per_bucket_ *= 2;
  bucket_seconds_ *= 2;
}

}  // namespace report
