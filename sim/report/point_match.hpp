// SPDX-License-Identifier: Apache-2.0
// Which of the requested points the machine reached, in their order, regardless of the steps
// in between.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "sim/report/gcode_path.hpp"
#include "sim/simulation/pins.hpp"

namespace report {

using Steps = std::array<std::int64_t, motor_count>;  // mechanical

struct RequestedLine {
  std::size_t file_line{};
  std::string text;
};

// Where the machine stood, and how many steps each axis had made until then, both ways.
struct MachineState {
  sim::Clock clock{};
  Steps position{};
  Steps steps_made{};
};

struct UnreachedPoint {
  RequestedLine line;
  Steps target{};
  MachineState nearest;  // of all states in which it could have been reached
};

// Points are taken as reached so that as many as possible are, each no earlier than the one before
// it: the longest common subsequence of points and positions. So a point that was left out makes no
// other one wrong. Between two reached points each axis makes exactly the steps that the file asks
// for between them: further ones, with which it may have come by later, are unasked.
class PointMatch {
 public:
  // The machine stands at `start`, which needs not be requested.
  explicit PointMatch(const MachineState& start);

  // The file requests this place, from now on. `detour`: how many more steps than those between the
  // places lead there, at most: of an arc, on which axes turn back. `other`: as good as the target.
  void ask(const Steps& target, RequestedLine line, const Steps& detour = {},
           const std::optional<Steps>& other = std::nullopt);
  // The machine's present position.
  void at(const MachineState& state);
  // Everything requested must have been made: what was not reached is missed. Where the machine is
  // said to rest since then, the last point is missed too unless it stands there.
  void settle(bool rests);
  // Nothing more comes, but lines may have been under way: they are neither reached nor missed.
  void abandon();
  // The machine has been moved here by something other than lines.
  void restart(const MachineState& here, const Steps& meant);

  // No line requested is under way.
  bool all_reached() const { return items_.empty(); }
  // Every line requested is decided on, and the last one known to be made.
  bool nothing_open() const { return items_.empty() && !last_line_open_; }
  std::uint64_t reached() const { return reached_; }
  const Steps& unasked_steps() const { return unasked_; }
  // Those that were missed since the last call.
  std::vector<UnreachedPoint> take_missed();
  const Steps& last_target() const { return last_target_; }
  // Where it is to stand after the last line, or a place as good.
  bool is_at_last_target(const Steps& position) const {
    return position == last_target_ || position == last_other_;
  }

 private:
  struct Item {
    bool is_at(const Steps& position) const { return position == target || position == other; }

    Steps target{};
    std::optional<Steps> other{};
    Steps detour{};
    std::vector<RequestedLine> lines;  // that end here, one after the other
    std::size_t reached{};  // lines of the best chain that ends here, within the window; 0: none
    std::ptrdiff_t before = -1;  // the item before it in that chain
    MachineState when;  // of the chain that ends here
    MachineState nearest;
    double distance{};  // of `nearest`
  };

  void note_nearest(Item& item, const MachineState& state) const;
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
  MachineState now_;
  std::uint64_t reached_ = 0;
  Steps unasked_{};
  std::vector<UnreachedPoint> missed_;
};

}  // namespace report
