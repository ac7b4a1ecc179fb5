// SPDX-License-Identifier: Apache-2.0
// The longest common subsequence, over the points that the machine can still be on its way to.
#include "sim/report/point_match.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace report {

namespace {

// No firmware is so many lines, each with a step at least, ahead of its motors.
constexpr std::size_t most_items = 512;
// An arc's end is at its own step also this near before it, by how it is rounded there.
constexpr std::int64_t turn_back_steps = 2;

}  // namespace

PointMatch::PointMatch(const MachineState& start)
    : last_target_(start.position), settled_target_(start.position), anchor_(start), now_(start) {}

void PointMatch::ask(const Steps& target, RequestedLine line, const Steps& detour,
                     const Steps& least, const std::optional<Steps>& other) {
  last_line_ = line;
  last_line_open_ = true;
  const bool same_place = !items_.empty() && items_.back().target == target;
  if (same_place && items_.back().reached == 0 && least == Steps{}) {
    items_.back().lines.push_back(std::move(line));
    for (std::size_t i = 0; i < detour.size(); ++i) items_.back().detour[i] += detour[i];
  } else {
    if (items_.size() == most_items) settle_oldest();
    Item& item = items_.emplace_back();
    item.target = target;
    item.other = other;
    item.detour = detour;
    item.least = least;
    item.lines.push_back(std::move(line));
    item.nearest = now_;
    item.distance = -1;
  }
  last_target_ = target;
  last_other_ = other;
  at(now_);
}

void PointMatch::at(const MachineState& state) {
  now_ = state;
  bool any = false;
  for (Item& item : items_) {
    any = any || item.is_at(state.position);
    if (item.reached == 0) note_nearest(item, state);
  }
  if (any) {
    update_chains(state);
    finish_reached_prefix();
  }
}

// A place where fewer axes are wrong is nearer; of equal ones that with fewer steps to go.
void PointMatch::note_nearest(Item& item, const MachineState& state) const {
  constexpr double wrong_axis = 1e12;
  double distance = 0;
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const auto off = static_cast<double>(std::llabs(state.position[i] - item.target[i]));
    distance += off == 0 ? 0 : wrong_axis + off;
  }
  // One that is there already, before its turn, is not a miss of this place.
  if (distance > 0 && (item.distance < 0 || distance < item.distance)) {
    item.distance = distance;
    item.nearest = state;
  }
}

bool PointMatch::made_least(const Item& item, std::ptrdiff_t before,
                            const MachineState& state) const {
  const MachineState& from = before < 0 ? anchor_ : items_[static_cast<std::size_t>(before)].when;
  for (std::size_t i = 0; i < item.least.size(); ++i) {
    if (state.steps_made[i] - from.steps_made[i] < item.least[i]) return false;
  }
  return true;
}

void PointMatch::update_chains(const MachineState& state) {
  std::size_t best = 0;
  std::ptrdiff_t best_end = -1;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    Item& item = items_[i];
    if (item.is_at(state.position) && best + item.lines.size() > item.reached &&
        made_least(item, best_end, state)) {
      item.reached = best + item.lines.size();
      item.before = best_end;
      item.when = state;
    }
    if (item.reached > best) {
      best = item.reached;
      best_end = static_cast<std::ptrdiff_t>(i);
    }
  }
}

// Where every line up to an item has been reached, no other chain can be better.
void PointMatch::finish_reached_prefix() {
  std::size_t lines = 0, count = 0;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    lines += items_[i].lines.size();
    if (items_[i].reached == lines) count = i + 1;
  }
  if (count > 0) {
    finish(count, std::vector<bool>(count, true));
    keep_chains_behind(count);
  }
}

// Of the chains so far only those count that went through the last of the finished items.
void PointMatch::keep_chains_behind(std::size_t finished) {
  for (Item& item : items_) {
    const std::ptrdiff_t before = item.before - static_cast<std::ptrdiff_t>(finished);
    const bool first = before == -1;
    const bool kept =
        item.reached > 0 &&
        (first || (before >= 0 && items_[static_cast<std::size_t>(before)].reached > 0));
    item.before = kept ? before : -1;
    item.reached = !kept   ? 0
                   : first ? item.lines.size()
                           : item.lines.size() + items_[static_cast<std::size_t>(before)].reached;
  }
}

std::vector<bool> PointMatch::best_chain() const {
  std::vector<bool> in_chain(items_.size());
  const auto best = std::ranges::max_element(items_, {}, &Item::reached);
  const bool any = best != items_.end() && best->reached > 0;
  for (std::ptrdiff_t i = any ? best - items_.begin() : -1; i >= 0;) {
    const auto index = static_cast<std::size_t>(i);
    in_chain[index] = true;
    i = items_[index].before;
  }
  return in_chain;
}

// Decides on the first items and forgets them.
void PointMatch::finish(std::size_t count, const std::vector<bool>& in_chain) {
  for (std::size_t i = 0; i < count; ++i) {
    Item& item = items_.front();
    for (std::size_t axis = 0; axis < item.target.size(); ++axis) {
      requested_since_anchor_[axis] +=
          std::llabs(item.target[axis] - settled_target_[axis]) + item.detour[axis];
    }
    settled_target_ = item.target;
    if (in_chain[i]) {
      reached_ += item.lines.size();
      count_unasked(item.when, most_left_after(item));
    } else {
      for (RequestedLine& line : item.lines) {
        missed_.push_back({std::move(line), item.target, item.nearest});
      }
    }
    items_.pop_front();
  }
}

// And what is left to be made then.
void PointMatch::count_unasked(const MachineState& until, const Steps& most_left) {
  for (std::size_t axis = 0; axis < most_left.size(); ++axis) {
    const std::int64_t made = until.steps_made[axis] - anchor_.steps_made[axis];
    const std::int64_t missing = requested_since_anchor_[axis] - made;
    unasked_[axis] += std::max<std::int64_t>(0, -missing);
    left_[axis] = std::clamp<std::int64_t>(missing, 0, most_left[axis]);
  }
  requested_since_anchor_ = left_;
  anchor_ = until;
}

// A place may be reached before the last steps of a detour: that of a line with one, and those of
// lines after it that are next to it.
Steps PointMatch::most_left_after(const Item& item) {
  const bool turns = item.detour != Steps{};
  bool near = true;
  for (std::size_t axis = 0; axis < item.target.size(); ++axis) {
    near = near && std::llabs(item.target[axis] - turned_at_[axis]) <= turn_back_steps;
  }
  Steps most = item.detour;
  for (std::size_t axis = 0; axis < most.size(); ++axis) most[axis] += near ? left_[axis] : 0;
  if (turns) turned_at_ = item.target;
  return most;
}

// The window is full: the older half is decided on as the best chain has it.
void PointMatch::settle_oldest() {
  const std::vector<bool> in_chain = best_chain();
  const std::size_t count = items_.size() / 2;
  finish(count, in_chain);
  // What remains is matched again, from the items of the chain that are left.
  std::size_t reached = 0;
  std::ptrdiff_t before = -1;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    Item& item = items_[i];
    const bool kept = in_chain[count + i];
    item.reached = kept ? (reached += item.lines.size()) : 0;
    item.before = kept ? std::exchange(before, static_cast<std::ptrdiff_t>(i)) : -1;
  }
}

void PointMatch::settle(bool rests) {
  at(now_);
  finish(items_.size(), best_chain());
  const bool listed = !missed_.empty() && missed_.back().line.file_line == last_line_.file_line;
  if (rests && last_line_open_ && !listed && !is_at_last_target(now_.position)) {
    --reached_;  // it was there, but on the way to another place
    missed_.push_back({last_line_, last_target_, now_});
  } else if (rests) {
    count_unasked(now_, {});
  }
  last_line_open_ = false;
}

void PointMatch::abandon() {
  const std::vector<bool> in_chain = best_chain();
  const auto last = std::ranges::find(in_chain.rbegin(), in_chain.rend(), true);
  finish(static_cast<std::size_t>(in_chain.rend() - last), in_chain);
  if (items_.empty() && is_at_last_target(now_.position)) count_unasked(now_, left_);
  items_.clear();
}

void PointMatch::restart(const MachineState& here, const Steps& meant) {
  items_.clear();
  last_line_open_ = false;
  now_ = anchor_ = here;
  last_target_ = settled_target_ = meant;
  last_other_.reset();
  requested_since_anchor_ = left_ = {};
}

std::vector<UnreachedPoint> PointMatch::take_missed() { return std::exchange(missed_, {}); }

}  // namespace report
