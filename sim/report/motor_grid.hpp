// SPDX-License-Identifier: Apache-2.0
// Between places of the tool and steps of the motors.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "sim/machine/mechanism.hpp"
#include "sim/report/step_grid.hpp"

namespace report {

HomePlace home_of(const machine::Mechanism& mechanism);

// The steps of all motors at a place, and back. `origin`: where the motors are when the firmware
// counts 0.
class MotorGrid {
 public:
  using Steps = std::array<std::int64_t, motor_count>;

  MotorGrid() = default;
  MotorGrid(std::shared_ptr<const machine::Mechanism> mechanism,
            const std::array<Resolution, motor_count>& steps_per_mm, const Steps& origin)
      : mechanism_(std::move(mechanism)), resolution_(steps_per_mm), origin_(origin) {}

  const machine::Mechanism& mechanism() const { return *mechanism_; }
  std::shared_ptr<const machine::Mechanism> shared_mechanism() const { return mechanism_; }
  const std::array<Resolution, motor_count>& resolution() const { return resolution_; }
  const Steps& origin() const { return origin_; }
  void set_resolution(std::size_t motor, Resolution value) { resolution_[motor] = value; }
  void set_origin(std::size_t motor, std::int64_t steps) { origin_[motor] = steps; }
  void move_origin(const Point& place, const Steps& steps);

  double steps_per_mm(std::size_t motor) const {
    return static_cast<double>(resolution_[motor]) / billionths;
  }
  // Nearest, halves away from zero.
  Steps steps_at(const Point& place) const;
  std::array<double, 3> place_mm(const Steps& steps) const;
  // The same, exactly where each axis has its motor.
  Point place_of_steps(const Steps& steps) const;
  // At a part of a move's way, 0 to 1, in steps between whole ones.
  std::array<double, motor_count> motors_on(const Move& move, double part) const;
  // How far the tool goes with a step of a motor, at most.
  double step_mm(const std::array<double, 3>& place) const;
  // How many more steps than those between its ends a move makes, at most, because motors turn
  // back on its way.
  Steps detour_of(const Move& move) const;

 private:
  Steps detour_of_arc(const Move& move) const;
  Steps sampled_detour_of(const Move& move) const;

  std::shared_ptr<const machine::Mechanism> mechanism_ = machine::cartesian_mechanism();
  std::array<Resolution, motor_count> resolution_{};
  Steps origin_{};
};

}  // namespace report
