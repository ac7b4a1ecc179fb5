// SPDX-License-Identifier: Apache-2.0
// How many requests one address may make: so many at once, and then so many a second.
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace web {

struct RateLimits {
  double burst = 400;  // requests
  double per_second = 100;
  double wrong_key = 20;  // counts as so many
  std::size_t most_addresses = 4096;  // that are remembered
};

// The address, of IPv6 its first 64 bits: a network has all others.
std::string client_of(std::string_view address);

// For any thread.
class RateLimit {
 public:
  using Clock = std::chrono::steady_clock;
  explicit RateLimit(RateLimits limits = {}) : limits_(limits) {}

  // False where the address has made too many requests; then it has not made this one.
  bool take(std::string_view address, Clock::time_point now = Clock::now());
  void note_wrong_key(std::string_view address, Clock::time_point now = Clock::now());

 private:
  struct Bucket {
    double left{};
    Clock::time_point filled;
  };
  Bucket& filled(std::string_view address, Clock::time_point now);
  void forget_full_ones(Clock::time_point now);
  double left_at(const Bucket& bucket, Clock::time_point now) const;

  RateLimits limits_;
  std::mutex mutex_;
  std::map<std::string, Bucket> buckets_;
};

}  // namespace web
