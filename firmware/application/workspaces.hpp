// SPDX-License-Identifier: Apache-2.0
// Where the host's coordinates of X, Y and Z lie in the machine's: the home offsets of M206 and
// M428, and the shift of G92, one for each of the systems G54 to G59.3.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "units/axes.hpp"
#include "units/position.hpp"

namespace application {

// As in Marlin: until one of the systems is selected G92 shifts the machine's own. A homed axis
// loses its shift, but the system that was selected keeps it, until it is selected again.
class Workspaces {
 public:
  static constexpr std::size_t axes = 3;  // X Y Z
  static constexpr std::size_t systems = 9;  // G54 to G59, G59.1 to G59.3
  using Places = std::array<units::Position, axes>;

  // The host's coordinate of the machine's 0.
  units::Position origin(std::size_t axis) const { return home_offset_[axis] + shift_[axis]; }
  const Places& home_offset() const { return home_offset_; }

  // G92: all coordinates of the axis become greater by this.
  void shift(std::size_t axis, const units::Position& by) {
    shift_[axis] += by;
    if (selected_) shifts_[*selected_][axis] = shift_[axis];
  }
  // G92.1.
  void reset_shifts() {
    shift_ = {};
    if (selected_) shifts_[*selected_] = {};
  }
  // G54 to G59.3.
  void select(std::size_t system) {
    selected_ = system;
    shift_ = shifts_[system];
  }
  void axis_homed(std::size_t axis) { shift_[axis] = {}; }
  void set_home_offset(std::size_t axis, const units::Position& offset) {
    home_offset_[axis] = offset;
  }

 private:
  Places home_offset_{};
  Places shift_{};
  std::array<Places, systems> shifts_{};
  std::optional<std::size_t> selected_;
};

}  // namespace application
