// SPDX-License-Identifier: Apache-2.0
// A stepper motor with the axis that it moves: follows steps while its torque suffices, up
// to the frame.
#pragma once

#include <cstdint>
#include <optional>

namespace plants {

// Positions are counted in microsteps from the point where the end stop switches.
struct AxisProperties {
  double steps_per_mm{};
  double torque_acceleration{};  // of the unloaded rotor under full torque, steps/s^2
  double speed_limit{};  // where friction and back EMF eat up the torque, steps/s
  std::int64_t microsteps_per_full_step = 16;
  std::optional<std::int64_t> lower_frame;  // the last position before the axis hits its frame
  std::optional<std::int64_t> upper_frame;
};

// The rotor hangs on the field like a mass on a spring: its torque is the sine of the lag, over a
// period of four full steps (Acarnley, "Stepping motors", chapter 4: the static torque
// characteristic). A lag of more than two full steps makes it fall into a neighbouring equilibrium:
// four full steps are lost.
class Axis {
 public:
  Axis(const AxisProperties& properties, std::int64_t position);

  // The field turns by one microstep at `seconds`; direction is 1 or -1.
  void step(double seconds, int direction);
  // A step() that the driver did not take after all (its pulse was too short).
  void undo_step(int direction);
  // The driver releases the motor: nothing moves until the next step.
  void release();

  std::int64_t position() const { return position_; }
  double position_mm() const { return static_cast<double>(position_) / properties_.steps_per_mm; }
  // Microsteps lost for want of torque, and at the frame.
  std::uint64_t slipped_steps() const { return slipped_steps_; }
  std::uint64_t frame_steps() const { return frame_steps_; }
  // Largest lag of the rotor so far, as a part of the lag at which it slips.
  double peak_load() const { return peak_load_; }

 private:
  void let_rotor_follow(double duration);
  void slip_if_left_behind();

  AxisProperties properties_;
  std::int64_t position_;  // of the field's equilibrium
  double lag_ = 0;  // rotor minus field, microsteps
  double speed_ = 0;  // of the rotor, microsteps/s
  double last_step_seconds_ = 0;
  double longest_interval_;  // of the integration, s
  double settle_seconds_;  // after which the rotor is at rest
  std::uint64_t slipped_steps_ = 0;
  std::uint64_t frame_steps_ = 0;
  double peak_load_ = 0;
};

}  // namespace plants
