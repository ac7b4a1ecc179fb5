// SPDX-License-Identifier: Apache-2.0
// Nothing here is taken from the analysis: tasks begin where the rule lets them, lines are handed
// over, times are read off.
#include "tests/timing/executive.hpp"

#include <algorithm>

namespace timing {

namespace {

using units::Task;

constexpr std::size_t heat = static_cast<std::size_t>(Task::heat);

}  // namespace

Clocks Run::longest_response(Task task, std::size_t looks) const {
  const auto& spans = tasks[static_cast<std::size_t>(task)];
  Clocks longest = 0;
  for (std::size_t i = 0; i + looks < spans.size(); ++i) {
    longest = std::max(longest, spans[i + looks].end - spans[i].begin);
  }
  return longest;
}

Clocks Run::longest_of_two_rounds() const {
  const auto& commands = tasks[static_cast<std::size_t>(Task::commands)];
  Clocks longest = 0;
  for (std::size_t i = 0; i + 1 < std::min(commands.size(), looks_pass.size()); ++i) {
    longest = std::max(longest, commands[i + 1].end - looks_pass[i]);
  }
  return longest;
}

Executive::Executive(const Facts& facts, const Load& load, Rate rate, Choice choice)
    : facts_(facts),
      load_(load),
      rate_(rate),
      choice_(std::move(choice)),
      longest_(std::min(facts.lines_of_a_pass * facts.least_line_clocks,
                        facts.horizon_ms * (rate.clock_hz / 1000))),
      rounding_(3 * rate.clock_hz / 1'000'000),
      motion_ends_(facts.refill_reserve),
      waiting_(facts.waiting_lines) {
  queue_.push_back(motion_ends_);
}

Run Executive::rounds(std::size_t number, bool sleeps) {
  for (std::size_t passes = 0; passes < 10'000 && rounds_ < number; ++passes) {
    pass();
    if (sleeps && !goes_on_) sleep();
  }
  return run_;
}

Executive::Feeds Executive::feeds(std::size_t passes) {
  heat_.is_timed = true;
  for (; passes > 0; --passes) {
    pass();
    if (!goes_on_) sleep();
  }
  Feeds feeds{.shortest = ~Clocks{0}};
  for (std::size_t i = 0; i + 1 < heat_.second_keys.size(); ++i) {
    feeds.longest = std::max(feeds.longest, heat_.second_keys[i + 1] - heat_.first_keys[i]);
    feeds.shortest = std::min(feeds.shortest, heat_.first_keys[i + 1] - heat_.first_keys[i]);
  }
  return feeds;
}

void Executive::pass() {
  pass_began_ = time_;
  time_ += choice_(*load_.start);
  run(static_cast<std::size_t>(Task::motion));
  gap(Task::motion);
  put_off_ = goes_on_ = collecting_;
  work();
  refill();
  gap(Task::refill);
  run(static_cast<std::size_t>(Task::rest));
  gap(Task::rest);
  if (heat_.second_keys.size() < heat_.first_keys.size()) heat_.second_keys.push_back(time_);
  run_.longest_pass = std::max(run_.longest_pass, time_ - pass_began_);
}

void Executive::gap(Task before) {
  time_ += choice_(*load_.gaps[static_cast<std::size_t>(before)]);
}

void Executive::work() {
  for (std::size_t task = 0; task < units::task_count; ++task) {
    if (facts_.allowances[task] == 0) continue;
    if (task == heat && !is_due()) continue;
    if (!may_begin(task)) continue;
    run(task);
    gap(static_cast<Task>(task));
    if (task == 1) run_.looks_pass.push_back(pass_began_);
    if (const auto room = facts_.lines_of_a_round - appended_; room > 0) {
      const Clocks more = std::min<Clocks>(choice_(room), facts_.waiting_lines - waiting_);
      waiting_ += more;
      appended_ += more;
    }
    const bool said = static_cast<Task>(task) == Task::reports && choice_(1) == 1;
    if (task == heat || said) {
      next_ = task + 1;
      goes_on_ = true;
      return;
    }
  }
  if (put_off_) ++run_.put_off;
  goes_on_ = put_off_;
  if (goes_on_) return;
  next_ = 0;
  appended_ = 0;
  ++rounds_;
}

// Each period both heaters, the second one half a period after the first. It is looked at when the
// pass begins.
bool Executive::is_due() {
  if (!heat_.is_timed) return true;
  const Clocks now = pass_began_ / (rate_.clock_hz / 1000);
  const Clocks after = heat_.turn == 0 ? facts_.heat_period_ms : facts_.heat_period_ms / 2;
  bool due = now - heat_.round_began_ms >= after;
  if (heat_.turn == 1) due = due && now - heat_.fed_ms >= facts_.least_heat_ms;
  // What has come since is no more than the planner holds.
  if (due && !heat_.was_due) waiting_ = facts_.waiting_lines;
  heat_.was_due = due;
  return due;
}

bool Executive::may_begin(std::size_t task) {
  if (put_off_ || task < next_) return false;
  if (!in_haste()) return true;
  const Clocks need =
      std::min(facts_.allowances[task] + facts_.refill_reserve, longest_ - facts_.refill_margin);
  // Whole microseconds show it a little early or late.
  const Clocks shown = known_in_hand(ended_) + choice_(rounding_);
  put_off_ = shown < need + choice_(rounding_);
  if (put_off_) next_ = task;
  return !put_off_;
}

void Executive::run(std::size_t task) {
  const Clocks begin = time_;
  time_ += choice_(*load_.tasks[task]);
  ended_ = time_;
  run_.tasks[task].push_back({begin, time_});
  if (task != heat || !heat_.is_timed) return;
  heat_.was_due = false;
  const Clocks now = begin / (rate_.clock_hz / 1000);
  if (heat_.turn == 0) heat_.round_began_ms = now;
  if (heat_.turn == 1) {
    heat_.first_keys.push_back(time_);
    heat_.fed_ms = now;
  }
  heat_.turn = 1 - heat_.turn;
}

Clocks Executive::known_in_hand(Clocks at) const {
  const Clocks until = full_ ? std::min(motion_ends_, full_until_) : motion_ends_;
  return until > at ? until - at : 0;
}

void Executive::refill() {
  Clocks looked = time_;
  full_ = false;
  if (resting_ && waiting_ > 0) {
    resting_ = false;
    collecting_ = true;
    collected_ = 0;
  }
  Clocks left = bound(Task::refill);
  const Clocks fixed = choice_(std::min(*load_.refill_without_line, left));
  time_ += fixed;
  left -= fixed;
  bool more = true;
  for (std::uint64_t i = 0; more && i < facts_.lines_of_a_refill; ++i) {
    looked = time_;
    while (!queue_.empty() && queue_.front() <= time_) queue_.pop_front();
    const Clocks end = collecting_ ? looked + collected_ : motion_ends_;
    more = waiting_ > 0 && end < looked + longest_;
    if (!more) break;
    if (queue_.size() > facts_.lines_of_a_pass) {
      full_ = true;
      full_until_ = looked + longest_;
      break;
    }
    const Clocks took = choice_(std::min(*load_.line, left));
    left -= took;
    hand_over(took);
  }
  if (collecting_ && (!more || full_ || collected_ >= longest_)) begin_motion();
}

void Executive::hand_over(Clocks took) {
  time_ += took;
  const Clocks lasts =
      facts_.least_line_clocks + facts_.least_line_clocks - choice_(facts_.least_line_clocks);
  --waiting_;
  if (collecting_) {
    collected_ += lasts;
  } else {
    run_.motion_has_ended = run_.motion_has_ended || time_ > motion_ends_;
    motion_ends_ = std::max(motion_ends_, time_) + lasts;
  }
  queue_.push_back(motion_ends_ + collected_);
  if (!collecting_) resting_ = waiting_ == 0;
}

void Executive::begin_motion() {
  collecting_ = false;
  resting_ = waiting_ == 0;
  motion_ends_ = std::max(motion_ends_, time_) + collected_;
  collected_ = 0;
}

// As long as motion lets it.
void Executive::sleep() {
  Clocks most = facts_.sleep_ms * (rate_.clock_hz / 1000);
  if (collecting_) return;
  if (in_haste()) {
    const Clocks in_hand = known_in_hand(time_);
    most = std::min(most, in_hand > facts_.refill_reserve ? in_hand - facts_.refill_reserve : 0);
  }
  time_ += choice_(most);
}

}  // namespace timing
