// SPDX-License-Identifier: Apache-2.0
// Compares the lines of the file with the steps where motors make lines as they are planned.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "sim/report/motor_grid.hpp"
#include "sim/report/path_check.hpp"
#include "sim/report/point_match.hpp"
#include "sim/report/step_judge.hpp"

namespace report {

// The ends of the lines to the step, and the way between them.
class PlainCheck final : public StepJudge {
 public:
  explicit PlainCheck(const MachineState& start) : match_(start) { path_.at(start.position); }

  void set_grid(const MotorGrid& grid) override {
    grid_ = grid;
    path_.set_grid(grid);
  }
  void set_play_mm(double play_mm) { path_.set_play_mm(play_mm); }

  void ask(const Move& move, RequestedLine line, const Steps& target,
           const std::optional<Steps>& other) override {
    const Steps detour = grid_.detour_of(move);
    match_.ask(target, std::move(line), detour, least_of(move, target, detour), other);
    for (const Move& way : move.ways()) path_.ask(way);
  }
  void at(const MachineState& state) override {
    match_.at(state);
    path_.at(state.position);
  }
  void end_freely() override { path_.ask_homing(); }
  void settle(bool rests) override {
    match_.settle(rests);
    path_.finish();
  }
  void abandon() override {
    match_.abandon();
    path_.forget();
  }
  void restart(const MachineState& here, const Steps& meant) override {
    match_.restart(here, meant);
    path_.at(here.position);
  }

  std::optional<bool> rested_at(sim::Clock) const override { return match_.all_reached(); }
  bool nothing_open() const override { return match_.nothing_open(); }
  const Steps& last_target() const override { return match_.last_target(); }
  bool is_at_last_target(const Steps& position) const override {
    return match_.is_at_last_target(position);
  }
  std::uint64_t reached() const override { return match_.reached(); }
  const Steps& unasked_steps() const override { return match_.unasked_steps(); }
  std::vector<UnreachedPoint> take_missed() override { return match_.take_missed(); }
  const PathCheck& path() const { return path_; }

 private:
  // An arc that ends about where it begins has begun and gone round only after about so many steps;
  // others do not come by their end before.
  Steps least_of(const Move& move, const Steps& target, const Steps& detour) const {
    constexpr std::int64_t near_steps = 2, rounding_steps = 8;
    Steps least{};
    for (std::size_t i = 0; i < least.size() && move.arc; ++i) {
      if (detour[i] == 0) continue;
      if (std::llabs(target[i] - match_.last_target()[i]) > near_steps) return {};
      least[i] = std::max<std::int64_t>(0, (detour[i] - rounding_steps) / 2);
    }
    return least;
  }

  MotorGrid grid_;
  PointMatch match_;
  PathCheck path_;
};

}  // namespace report
