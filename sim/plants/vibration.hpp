// SPDX-License-Identifier: Apache-2.0
// A mass on a spring and a damper, whose other end follows the steps of an axis: one mode of
// vibration of a printer.
#pragma once

namespace plants {

// In the unit of the axis' position; exact for a position that changes in steps.
class Vibration {
 public:
  // `hertz` undamped, more than 0; damping ratio 0 .. below 1.
  Vibration(double hertz, double damping);

  // The axis moves to `position` at `seconds`, which never fall.
  void move_to(double seconds, double position);
  // The state at this time, without a move.
  void advance(double seconds);

  // The mass less the axis.
  double deflection() const { return deflection_; }
  // The greatest deflection that would follow if the axis stood still and nothing were damped.
  double amplitude() const;

 private:
  double angular_;  // undamped, rad/s
  double damping_;
  double damped_;  // rad/s
  double seconds_ = 0;
  double position_ = 0;
  double deflection_ = 0;
  double speed_ = 0;  // of the deflection
};

}  // namespace plants
