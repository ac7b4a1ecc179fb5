// SPDX-License-Identifier: Apache-2.0
// What a G-code file calls the machine's places: the systems G54 to G59.3, G92, and the home
// offsets of M206. Written from Marlin's documentation, independently of the firmware.
#pragma once

#include <array>
#include <cstddef>

#include "sim/report/femtometers.hpp"

namespace report {

class FileCoordinates {
 public:
  // What the file calls the machine's 0 of X, Y or Z.
  Femtometers zero(std::size_t axis) const { return home_[axis] + shift_.at(axis); }

  void choose(std::size_t system) {
    chosen_ = system + 1;
    shift_ = kept_.at(chosen_);
  }
  // G92.
  void move_by(std::size_t axis, Femtometers distance) {
    shift_.at(axis) += distance;
    if (chosen_ != machine) kept_.at(chosen_).at(axis) = shift_.at(axis);
  }
  // G92.1
  void clear() {
    shift_ = {};
    if (chosen_ != machine) kept_.at(chosen_) = {};
  }
  void home(std::size_t axis) { shift_.at(axis) = 0; }
  Femtometers home_offset(std::size_t axis) const { return home_.at(axis); }
  void set_home_offset(std::size_t axis, Femtometers offset) { home_.at(axis) = offset; }

 private:
  using Places = std::array<Femtometers, 3>;
  static constexpr std::size_t machine = 0;  // none of the nine is chosen

  Places home_{};
  Places shift_{};
  std::array<Places, 10> kept_{};
  std::size_t chosen_ = machine;
};

}  // namespace report
