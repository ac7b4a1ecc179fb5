// SPDX-License-Identifier: Apache-2.0
// A bucket of tokens for each address.
#include "host/web/rate.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>

namespace web {

std::string client_of(std::string_view address) {
  const std::string text(address);
  std::array<unsigned char, 16> bytes{};
  if (inet_pton(AF_INET6, text.c_str(), bytes.data()) != 1) return text;
  constexpr std::array<unsigned char, 12> mapped{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};
  const bool is_mapped = std::equal(mapped.begin(), mapped.end(), bytes.begin());  // IPv4
  if (!is_mapped) std::fill(bytes.begin() + 8, bytes.end(), static_cast<unsigned char>(0));
  std::array<char, INET6_ADDRSTRLEN> network{};
  inet_ntop(AF_INET6, bytes.data(), network.data(), network.size());
  return network.data();
}

double RateLimit::left_at(const Bucket& bucket, Clock::time_point now) const {
  const std::chrono::duration<double> passed = now - bucket.filled;
  return std::min(limits_.burst, bucket.left + passed.count() * limits_.per_second);
}

RateLimit::Bucket& RateLimit::filled(std::string_view address, Clock::time_point now) {
  const std::string client = client_of(address);
  if (!buckets_.contains(client) && buckets_.size() >= limits_.most_addresses) {
    forget_full_ones(now);
  }
  Bucket& bucket = buckets_.try_emplace(client, limits_.burst, now).first->second;
  bucket.left = left_at(bucket, now);
  bucket.filled = now;
  return bucket;
}

// They are as if they had never been here. Where none is full, the fullest one goes.
void RateLimit::forget_full_ones(Clock::time_point now) {
  std::erase_if(buckets_,
                [&](const auto& each) { return left_at(each.second, now) >= limits_.burst; });
  if (buckets_.size() < limits_.most_addresses) return;
  buckets_.erase(std::ranges::max_element(
      buckets_, {}, [&](const auto& each) { return left_at(each.second, now); }));
}

bool RateLimit::take(std::string_view address, Clock::time_point now) {
  const std::scoped_lock lock(mutex_);
  Bucket& bucket = filled(address, now);
  if (bucket.left < 1) return false;
  bucket.left -= 1;
  return true;
}

void RateLimit::note_wrong_key(std::string_view address, Clock::time_point now) {
  const std::scoped_lock lock(mutex_);
  Bucket& bucket = filled(address, now);
  // Below nothing, so that the next one waits for all of it.
  bucket.left = std::max(-limits_.wrong_key, bucket.left - limits_.wrong_key);
}

}  // namespace web
