// SPDX-License-Identifier: Apache-2.0
// Holds every XY step against the lines that the G-code asks for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>

#include "sim/devices/host_listener.hpp"
#include "sim/devices/step_edge.hpp"
#include "sim/report/gcode_path.hpp"

namespace report {

// The G-code's points are taken in order. While a line is walked, the distance of each edge from it
// counts (edges of one clock together); it is done when the edges have arrived at its end to the
// step. Homing is free until it is acknowledged.
class PathCheck : public devices::StepListener, public devices::HostListener {
 public:
  // `origin`: mechanical positions at the beginning, which the G-code calls 0 until it homes.
  PathCheck(std::array<double, 2> steps_per_mm, std::array<std::int64_t, 2> origin);

  void stepped(const devices::StepEdge& edge) override;
  void command_sent(sim::Clock now, std::size_t file_line, std::string_view command) override;
  void command_acknowledged(sim::Clock now, std::size_t file_line, std::string_view command,
                            bool executed) override;

  double max_deviation_mm() const { return max_deviation_mm_; }
  // Of the executed moves, in X, Y and Z, as the G-code asks for them.
  double length_mm() const { return length_mm_; }
  std::uint64_t points_reached() const { return points_reached_; }
  std::uint64_t points_missed() const { return points_missed_; }
  bool homed() const { return homed_; }

 private:
  struct Item {
    bool homing{};
    std::array<bool, 2> homed_axes{};
    std::array<double, 2> from{}, to{};  // mm, machine
    std::array<std::int64_t, 2> target{};  // steps, mechanical
  };

  Item item_of(const Move& move) const;
  double distance_mm(const Item& item) const;
  void judge_position();
  void pass_reached_points();
  void pass_lost_point();
  void finish_all();
  void finish_homing(const Item& homing);

  std::array<double, 2> steps_per_mm_;
  std::array<std::int64_t, 2> origin_;
  std::array<std::int64_t, 2> position_;
  sim::Clock last_edge_ = 0;
  bool judged_ = true;  // position_ has been held against the lines
  GcodePath gcode_;
  GcodePath gcode_before_;  // the command in flight
  bool item_in_flight_ = false;
  double length_in_flight_ = 0;
  std::deque<Item> items_;
  double max_deviation_mm_ = 0;
  double length_mm_ = 0;
  std::uint64_t points_reached_ = 0;
  std::uint64_t points_missed_ = 0;
  bool homed_ = false;
};

}  // namespace report
