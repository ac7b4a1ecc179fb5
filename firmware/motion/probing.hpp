// SPDX-License-Identifier: Apache-2.0
// Finds the height of the bed at one place: up, across, down until the probe triggers, back, and
// down again slowly. Each way down has an end, and the probe may not be triggered before it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "units/axes.hpp"
#include "units/position.hpp"
#include "units/quantity.hpp"

namespace motion {

// What the machine description says of its probe, which is fixed to the nozzle.
struct ProbeSettings {
  std::uint8_t input{};  // of the end stops, 0 .. 7
  // From the nozzle to where the probe measures; Z: of the nozzle where it touches the bed, from
  // where the probe triggers. Changed by M851.
  std::array<units::Nanometers, 3> offset{};
  units::MicrometersPerSecond fast_speed{};  // of Z
  units::MicrometersPerSecond slow_speed{};
  units::MicrometersPerSecond travel_speed{};
  units::Nanometers clearance{};  // Z of the nozzle on its way to a place
  units::Nanometers back_off{};  // between the fast and the slow way down
  units::Nanometers deepest{};  // the lowest height at which the bed is looked for

  // Z of the nozzle there.
  units::Nanometers end_of_descent() const { return deepest - offset[2]; }
};

enum class ProbeFault : std::uint8_t {
  not_triggered,  // down to the deepest place
  triggered_early,  // before the way down, or on the way to the place
  does_not_open,  // after the back-off
};

std::string_view describe(ProbeFault fault);

// To be sampled after everything that the last move started has ended.
struct ProbingObservation {
  bool stopped{};  // the hardware ended the last requested move by its stop mask
  bool triggered{};
  units::PerAxis<units::Position> place;  // of the nozzle
};

// A straight move, to be executed and flushed as a line of its own.
struct ProbingMove {
  units::PerAxis<units::Position> target{};
  units::MicrometersPerSecond speed{};
  bool stops{};  // when the probe triggers
};

class Probing {
 public:
  // The probe goes to X and Y, which the nozzle must be able to reach.
  void start(const ProbeSettings& settings, units::Nanometers x, units::Nanometers y);
  // Neither a result nor a fault comes of it.
  void cancel() {
    state_ = State::idle;
    result_.reset();
  }
  bool active() const { return state_ != State::idle; }

  // The next move, as long as it is active; to be called when the axes are at rest.
  std::optional<ProbingMove> update(const ProbingObservation& observation);

  // Of the last one: the bed's height.
  std::optional<units::Nanometers> result() const { return result_; }
  std::optional<ProbeFault> fault() const { return fault_; }
  // Where the probe is, or was.
  units::Nanometers x() const { return x_; }
  units::Nanometers y() const { return y_; }

 private:
  enum class State : std::uint8_t {
    idle,
    lift,
    travel,
    arrive,
    descend,
    back_off,
    descend_slowly,
    raise
  };

  std::optional<ProbingMove> move(State next, const units::PerAxis<units::Position>& target,
                                  units::MicrometersPerSecond speed, bool stops);
  std::optional<ProbingMove> fail(ProbeFault fault);

  ProbeSettings settings_{};
  units::Nanometers x_{}, y_{};
  State state_{State::idle};
  std::optional<units::Nanometers> result_;
  std::optional<ProbeFault> fault_;
};

}  // namespace motion
