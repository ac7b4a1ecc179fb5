// SPDX-License-Identifier: Apache-2.0
// How far the XY steps deviate from the lines that the G-code requests, and whether Z and E follow.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "sim/report/gcode_path.hpp"
#include "sim/report/motor_grid.hpp"

namespace report {

// The lines are taken in order. While one is walked, the distance of each position from it counts;
// it is done when the positions have arrived at its end to the step, or come nearer to the next
// line. Homing is free until it is finished.
class PathCheck {
 public:
  void set_grid(const MotorGrid& grid);
  // While a motor crosses the play of its drive, the other axis goes on along the line.
  void set_play_mm(double play_mm) { play_mm_ = play_mm; }

  // A line of the file, or homing, is requested from now on.
  void ask(const Move& move);
  void ask_homing() { items_.push_back({.homing = true}); }
  // The axes stand here now, mechanical.
  void at(const MotorGrid::Steps& position);
  // All requested motion is complete, or will not be made.
  void finish();
  void forget() { items_.clear(); }

  double max_deviation_mm() const { return max_deviation_mm_; }
  // The same in steps of the coarser of X and Y, without what chords and play explain; where motors
  // are not axes, in the tool's way with a step of a motor there.
  double max_deviation_steps() const { return max_deviation_steps_; }
  // Lines of many steps in whose middle Z or E was not in the middle of its own way.
  std::uint64_t lines_apart() const { return lines_apart_; }
  // How far Z was from the height above the mesh, beyond what chords and steps explain; 0: nowhere.
  double max_height_error_mm() const { return max_height_error_mm_; }

 private:
  struct Item {
    bool homing{};
    std::array<double, 2> from{}, to{};  // mm, machine
    MotorGrid::Steps start{}, target{};  // steps, mechanical
    bool apart{};
    std::optional<ArcShape> arc{};
    std::array<double, 2> z{};  // mm at its ends, without the mesh
    std::shared_ptr<const BedMesh> mesh{};
    bool left{};  // an arc that ends where it begins has been away from there
  };

  double part_of_way(const Item& item) const;
  double distance_mm(const Item& item) const;
  double distance_from_arc_mm(const ArcShape& arc) const;
  double place_mm(std::size_t axis) const { return place_[axis]; }
  double steps_of(double distance_mm) const;
  void note_deviation(double distance_mm);
  bool reached(const Item& item) const;
  void watch_z_and_e(Item& item);
  void watch_height(const Item& item);
  void pass_reached_lines();
  void pass_lost_line();

  std::array<double, 3> steps_per_mm_{1, 1, 1};
  MotorGrid grid_;
  MotorGrid::Steps position_{};
  std::array<double, 3> place_{};  // of the tool, mm
  std::deque<Item> items_;
  double play_mm_ = 0;
  double max_deviation_mm_ = 0;
  double max_deviation_steps_ = 0;
  std::uint64_t lines_apart_ = 0;
  double max_height_error_mm_ = 0;
};

}  // namespace report
