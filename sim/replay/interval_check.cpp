// SPDX-License-Identifier: Apache-2.0
// The choice of intervals, and the threads that replay them.
#include "sim/replay/interval_check.hpp"

#include <algorithm>
#include <exception>
#include <utility>

namespace replay {

namespace {

// An interval and its two snapshots take some 300 KiB.
constexpr std::size_t most_waiting = 16;

}  // namespace

IntervalCheck::IntervalCheck(const CheckPlan& plan, std::function<Replay()> make_replay)
    : plan_(plan), make_replay_(std::move(make_replay)), random_(plan.seed) {
  for (unsigned i = 0; i < plan_.threads; ++i) threads_.emplace_back([this] { work(); });
}

IntervalCheck::~IntervalCheck() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
  }
  end_threads();
}

void IntervalCheck::end_threads() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void IntervalCheck::enqueue(Interval interval) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.size() < most_waiting; });
  waiting_.push_back(std::move(interval));
  ++enqueued_;
  changed_.notify_all();
}

// Of n intervals each is chosen with the same probability, without n being known before: the
// n-th takes the place of one of the `count` with probability count / n.
void IntervalCheck::take(Interval interval) {
  ++taken_;
  if (interval.number < plan_.first || interval.number > plan_.last) return;
  if (!plan_.count) {
    enqueue(std::move(interval));
  } else if (chosen_.size() < *plan_.count) {
    chosen_.push_back(std::move(interval));
  } else if (const std::uint64_t place = random_() % taken_; place < chosen_.size()) {
    chosen_[place] = std::move(interval);
  }
}

CheckResult IntervalCheck::finish() {
  for (Interval& interval : chosen_) enqueue(std::move(interval));
  chosen_.clear();
  end_threads();
  result_.intervals = taken_;
  result_.dropped = enqueued_ - result_.replayed;
  std::ranges::sort(result_.differences, {}, &Difference::interval);
  return result_;
}

void IntervalCheck::put_result(const Interval& interval, std::optional<Difference> difference) {
  const std::lock_guard lock(mutex_);
  ++result_.replayed;
  if (!interval.end) ++result_.without_end;
  result_.clocks += interval.end_clock - interval.start->clock;
  if (difference) result_.differences.push_back(std::move(*difference));
}

void IntervalCheck::work() {
  Replay replay;
  for (;;) {
    Interval interval;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      interval = std::move(waiting_.front());
      waiting_.pop_front();
      if (plan_.cancelled()) waiting_.clear();
    }
    changed_.notify_all();
    if (plan_.cancelled()) continue;
    try {
      if (!replay) replay = make_replay_();
      put_result(interval, replay(interval));
    } catch (const std::exception& failed) {  // of the hardware, above all
      replay = nullptr;
      put_result(interval, Difference{.interval = interval.number,
                                      .clock = interval.start->clock,
                                      .what = failed.what(),
                                      .recorded = "",
                                      .replayed = ""});
    }
  }
}

}  // namespace replay
