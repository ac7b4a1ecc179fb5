// SPDX-License-Identifier: Apache-2.0
// Events that wait for their receiver, up to a bound.
#pragma once

#include <algorithm>
#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "host/notify/event.hpp"

namespace notify {

struct BacklogLimits {
  std::size_t events = 200;  // one more pushes out the oldest
  std::chrono::milliseconds age{std::chrono::hours{24}};  // older ones are dropped
};

// For one thread at a time.
class Backlog {
 public:
  using Clock = std::chrono::steady_clock;
  explicit Backlog(BacklogLimits limits = {}) : limits_(limits) {}

  void add(const Event& event) {
    waiting_.push_back({.event = event, .since = Clock::now()});
    if (waiting_.size() > limits_.events) drop_oldest();
  }
  // The oldest; nothing where none waits.
  std::optional<Event> next() {
    while (!waiting_.empty() && Clock::now() - waiting_.front().since > limits_.age) drop_oldest();
    return waiting_.empty() ? std::nullopt : std::optional(waiting_.front().event);
  }
  // It has been dealt with; it may have been pushed out meanwhile.
  void remove(const std::string& id) {
    if (!waiting_.empty() && waiting_.front().event.id == id) waiting_.pop_front();
  }
  // Since the last call.
  std::size_t take_dropped() { return std::exchange(dropped_, 0); }
  std::size_t size() const { return waiting_.size(); }

 private:
  struct Waiting {
    Event event;
    Clock::time_point since;
  };
  void drop_oldest() {
    waiting_.pop_front();
    ++dropped_;
  }

  BacklogLimits limits_;
  std::deque<Waiting> waiting_;
  std::size_t dropped_ = 0;
};

// Pauses between attempts: each twice as long as the one before.
struct Pauses {
  std::chrono::milliseconds first{1000}, longest{60'000};
  std::chrono::milliseconds after(int failures) const {
    auto pause = first;
    for (int i = 1; i < failures && pause < longest; ++i) pause *= 2;
    return std::min(pause, longest);
  }
};

}  // namespace notify
