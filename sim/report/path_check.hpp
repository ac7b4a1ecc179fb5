// SPDX-License-Identifier: Apache-2.0
// How far the XY steps leave the lines that the G-code asks for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>

#include "sim/report/gcode_path.hpp"
#include "sim/report/step_grid.hpp"

namespace report {

// The lines are taken in order. While one is walked, the distance of each position from it counts;
// it is done when the positions have arrived at its end to the step, or come nearer to the next
// line. Homing is free until it is finished.
class PathCheck {
 public:
  // `origin`: mechanical position of what the G-code calls 0, on X and Y.
  void set_grid(const std::array<Resolution, 2>& steps_per_mm,
                const std::array<std::int64_t, 2>& origin);

  // A line of the file, or homing, is asked for from now on.
  void ask(const Move& move);
  void ask_homing() { items_.push_back({.homing = true}); }
  // X and Y stand here now, mechanical.
  void at(const std::array<std::int64_t, 2>& position);
  // Everything asked for has been made, or will not be made.
  void finish();
  void forget() { items_.clear(); }

  double max_deviation_mm() const { return max_deviation_mm_; }

 private:
  struct Item {
    bool homing{};
    std::array<double, 2> from{}, to{};  // mm, machine
    std::array<std::int64_t, 2> target{};  // steps, mechanical
  };

  double distance_mm(const Item& item) const;
  void pass_reached_lines();
  void pass_lost_line();

  std::array<double, 2> steps_per_mm_{1, 1};
  std::array<Resolution, 2> resolution_{};
  std::array<std::int64_t, 2> origin_{};
  std::array<std::int64_t, 2> position_{};
  std::deque<Item> items_;
  double max_deviation_mm_ = 0;
};

}  // namespace report
