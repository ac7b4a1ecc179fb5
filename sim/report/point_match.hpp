// SPDX-License-Identifier: Apache-2.0
// Which of the requested points the machine reached, in their order, regardless of the steps
// in between.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "sim/report/step_judge.hpp"

namespace report {

// Points are taken as reached so that as many as possible are, each no earlier than the one before
// it: the longest common subsequence of points and positions. So a point that was left out makes no
// other one wrong. Between two reached points each axis makes exactly the steps that the file asks
// for between them: further ones, with which it may have come by later, are unasked.
class PointMatch {
 public:
  // The machine stands at `start`, which needs not be requested.
  explicit PointMatch(const MachineState& start);

  // The file requests this place, from now on. `detour`: how many more steps than those between the
  // places lead there, at most: of an arc, on which axes turn back. `least`: so many must be made
  // before it is reached: of a circle, which begins there. `other`: as good as the target.
  void ask(const Steps& target, RequestedLine line, const Steps& detour = {},
           const Steps& least = {}, const std::optional<Steps>& other = std::nullopt);

  // As those of StepJudge.
  void at(const MachineState& state);
  void settle(bool rests);
  void abandon();
  void restart(const MachineState& here, const Steps& meant);
  bool all_reached() const { return items_.empty(); }
  bool nothing_open() const { return items_.empty() && !last_line_open_; }
  std::uint64_t reached() const { return reached_; }
  const Steps& unasked_steps() const { return unasked_; }
  std::vector<UnreachedPoint> take_missed();
  const Steps& last_target() const { return last_target_; }
  bool is_at_last_target(const Steps& position) const {
    return position == last_target_ || position == last_other_;
  }

 private:
  struct Item {
    bool is_at(const Steps& position) const { return position == target || position == other; }

    Steps target{};
    std::optional<Steps> other{};
    Steps detour{}, least{};
    std::vector<RequestedLine> lines;  // that end here, one after the other
    std::size_t reached{};  // lines of the best chain that ends here, within the window; 0: none
    std::ptrdiff_t before = -1;  // the item before it in that chain
    MachineState when;  // of the chain that ends here
    MachineState nearest;
    double distance{};  // of `nearest`
  };

  void note_nearest(Item& item, const MachineState& state) const;
  bool made_least(const Item& item, std::ptrdiff_t before, const MachineState& state) const;
  void count_unasked(const MachineState& until, const Steps& most_left);
  Steps most_left_after(const Item& item);
  void update_chains(const MachineState& state);
  void finish(std::size_t count, const std::vector<bool>& in_chain);
  void finish_reached_prefix();
  void keep_chains_behind(std::size_t finished);
  std::vector<bool> best_chain() const;
  void settle_oldest();

  std::deque<Item> items_;
  Steps last_target_;  // of the last line requested
  std::optional<Steps> last_other_{};
  RequestedLine last_line_;
  bool last_line_open_ = false;  // has not been settled
  Steps settled_target_;  // of the last line that is decided on
  MachineState anchor_;  // when the last reached point was reached
  Steps requested_since_anchor_{};
  Steps turned_at_{};  // where the last line with a detour ends
  Steps left_{};  // of its detour
  MachineState now_;
  std::uint64_t reached_ = 0;
  Steps unasked_{};
  std::vector<UnreachedPoint> missed_;
};

}  // namespace report
