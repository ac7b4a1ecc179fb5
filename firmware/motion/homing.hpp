// SPDX-License-Identifier: Apache-2.0
// Finds the end stops of the axes of one G28, one axis after another: fast, back off, slow. An end
// stop that is already pressed is released first. If an end stop never closes, the axis pushes on;
// so no approach goes farther than it must.
#pragma once

#include <cstdint>

#include "motion/fault.hpp"
#include "motion/limits.hpp"
#include "units/axes.hpp"
#include "units/quantity.hpp"

namespace motion {

// The inputs of homing. To be sampled after everything that the last request started has been
// handed over.
struct HomingObservation {
  bool at_rest{};  // planner empty and step generator idle (or stopped, and acknowledged)
  bool stopped{};  // the hardware ended the last requested move by its stop mask
  std::uint8_t end_stops{};  // levels, bit = input, 1 = pressed
};

// A straight move of one axis, or of X, Y and Z alike, from where it is, to be executed and flushed
// as a line of its own.
struct HomingMove {
  units::Axis axis{};
  bool together{};
  units::Nanometers distance{};  // signed, of each
  units::MicrometersPerSecond speed{};
  std::uint8_t stop_mask{};
};

// The request of homing.
struct HomingRequest {
  enum class Kind : std::uint8_t {
    nothing,  // wait, or not active
    move,  // start `move`
    set_position,  // set hardware's and planner's position of `axis` to `position`; it is homed now
    finished,  // all axes are homed
    fault,  // given up with `fault`; no axis moves
  };
  Kind kind{};
  HomingMove move{};
  units::Axis axis{};
  units::Nanometers position{};
  Fault fault{};
};

class Homing {
 public:
  enum class State : std::uint8_t {
    idle,
    begin_together,
    approach_together,
    begin_axis,
    release,
    approach,
    back_off,
    approach_slowly
  };

  // Begins with the axes of `axes` that have an end stop, in the order X, Y, Z. No axis: finished
  // at the first update. An end stop is at most the axis' travel away, and is looked for as far and
  // once more its back-off. `together`: X, Y and Z first go on together until an end stop closes.
  void start(units::AxisSet axes, const Limits& limits, bool together = false);
  // Cancels homing (emergency stop, M410).
  void cancel() { state_ = State::idle; }

  bool active() const { return state_ != State::idle; }
  State state() const { return state_; }

  // To be called again and again while active; never waits.
  HomingRequest update(const HomingObservation& observation);

 private:
  const HomingParameters& parameters() const;
  std::uint8_t stop_mask() const;
  bool pressed(const HomingObservation& observation) const;
  units::Nanometers towards_end_stop(units::Nanometers distance) const;
  HomingRequest begin_together();
  HomingRequest begin_axis(const HomingObservation& observation);
  HomingRequest approach(units::Nanometers distance);
  HomingRequest move(State next, units::Nanometers distance, units::MicrometersPerSecond speed,
                     std::uint8_t mask);
  HomingRequest fail(Fault fault);

  Limits limits_{};
  units::AxisSet remaining_{};
  units::Axis axis_{};
  State state_{State::idle};
};

}  // namespace motion
