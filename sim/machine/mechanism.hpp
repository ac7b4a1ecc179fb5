// SPDX-License-Identifier: Apache-2.0
// How the motors of the simulated printer move its tool: written from the machine, and sharing
// nothing with the firmware.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "sim/devices/switch_place.hpp"

namespace machine {

__extension__ using ExactLength = __int128;  // fm; of an angle, in 10^-12 degrees

// Lengths in mm, angles of motors that turn an arm in degrees. Motors and axes: x y z.
class Mechanism {
 public:
  using Place = std::array<double, 3>;
  using ExactPlace = std::array<ExactLength, 3>;

  // How far an axis can go beyond its end stop and beyond its travel.
  static constexpr double lower_frame_mm = 2.0;
  static constexpr double upper_frame_mm = 5.0;

  Mechanism() = default;
  Mechanism(const Mechanism&) = delete;
  Mechanism& operator=(const Mechanism&) = delete;
  virtual ~Mechanism() = default;

  // Each axis has its motor.
  virtual bool is_cartesian() const { return false; }
  virtual Place motors_of(const Place& tool) const = 0;
  virtual Place place_of(const Place& motors) const = 0;
  // Where the motors are to be for a place, as the firmware's documentation defines it.
  virtual ExactPlace exact_motors_of(const ExactPlace& tool) const = 0;
  // Lines are made of chords that may leave them by so much.
  virtual double chord_deviation_mm() const { return 0; }
  // The third motor is Z's.
  virtual bool has_own_z() const { return true; }
  // How far a motor's movement of 1 moves the tool here, at most.
  virtual double gain_at(const Place& tool) const;
  // G28 finds all axes at once, and ends here.
  virtual bool homes_all() const { return false; }
  virtual Place home() const { return {}; }
  // Where the printer may be switched on, by numbers from 0 to 1: not far from the end stops.
  virtual Place start(const Place& random) const;
  // Whether something hits the frame or the bed. `travel`: of the axes of the description.
  virtual bool is_beyond_frame(const Place& motors, const Place& travel) const;
  virtual devices::SwitchPlace end_stop(std::size_t axis, double steps_per_mm) const = 0;
};

std::shared_ptr<const Mechanism> cartesian_mechanism();
std::shared_ptr<const Mechanism> core_xy_mechanism();

}  // namespace machine
