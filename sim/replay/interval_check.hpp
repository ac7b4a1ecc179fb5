// SPDX-License-Identifier: Apache-2.0
// Replays intervals, all of them or some at random, on several threads.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "sim/replay/interval.hpp"

namespace replay {

// Where a replay first differs from what was recorded.
struct Difference {
  std::size_t interval{};
  sim::Clock clock{};
  std::string what;
  std::string recorded, replayed;
};

using Replay = std::function<std::optional<Difference>(const Interval&)>;

struct CheckPlan {
  std::optional<std::size_t> count;  // so many at random; all where there is none
  std::size_t first = 1, last = std::numeric_limits<std::size_t>::max();  // no others, by number
  std::uint64_t seed = 0;
  unsigned threads = 1;
  // Checked before each replay, on any thread: if true, the waiting intervals are dropped.
  std::function<bool()> cancelled = [] { return false; };
};

struct CheckResult {
  std::size_t intervals{};  // that there were
  std::size_t replayed{};
  std::size_t dropped{};  // chosen, and not replayed because it was cancelled
  std::size_t without_end{};  // replayed without a snapshot at their end: only pins compared
  sim::Clock clocks{};  // of those replayed
  std::vector<Difference> differences;  // at most one for each interval, in their order
};

class IntervalCheck {
 public:
  // `make_replay` is called once on each thread.
  IntervalCheck(const CheckPlan& plan, std::function<Replay()> make_replay);
  // Replays no more.
  ~IntervalCheck();

  // Waits while too many are waiting. Chooses: where some are to be replayed at random, none is
  // before finish().
  void take(Interval interval);

  // Replays the waiting intervals. No further ones are accepted.
  CheckResult finish();

 private:
  void work();
  void enqueue(Interval interval);
  void put_result(const Interval& interval, std::optional<Difference> difference);
  void end_threads();

  CheckPlan plan_;
  std::function<Replay()> make_replay_;
  std::mt19937_64 random_;
  std::size_t taken_ = 0;
  std::vector<Interval> chosen_;
  std::size_t enqueued_ = 0;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Interval> waiting_;  // the rest belongs to the mutex too
  bool ended_ = false;
  CheckResult result_;
  std::vector<std::thread> threads_;
};

}  // namespace replay
