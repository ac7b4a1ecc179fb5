// SPDX-License-Identifier: Apache-2.0
// Judges step, direction and enable pins clock by clock as motor drivers and a machine would:
// pulses counted, guards kept, no step where none may be.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace tests {

class PinFault : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class MotorPinWatch {
 public:
  static constexpr std::size_t axes = 5;
  using Positions = std::array<std::int32_t, axes>;

  // In clocks, at least 1.
  struct Guard {
    std::uint32_t high = 50, low = 50, setup = 10, hold = 10;
    bool both_edges = false;
  };

  // `forbidden`: no axis may begin a step with this clock edge, and why. Throws PinFault.
  void watch(std::uint64_t clock, std::uint32_t step, std::uint32_t direction, std::uint32_t enable,
             const char* forbidden) {
    stepped_ = false;
    for (std::size_t i = 0; i < axes; ++i) {
      const auto level = [i](std::uint32_t pins) { return (pins >> i & 1u) != 0; };
      Axis& axis = axis_[i];
      clock_ = clock;
      axis_number_ = i;
      if (level(direction) != level(direction_)) {
        want(clock - axis.stepped, axis.guard_of_step.hold, "hold time");
        axis.turned = clock;
        axis.setup = axis.guard.setup;
      }
      if (level(step) == level(step_)) continue;
      const bool rises = level(step);
      const std::uint32_t least = rises ? axis.guard_of_step.low : axis.guard_of_step.high;
      want(clock - axis.changed, least, rises ? "low time" : "high time");
      axis.changed = clock;
      if (!rises && !axis.guard.both_edges) continue;
      want(clock - axis.turned, axis.setup, "set-up time");
      if (level(direction) != level(direction_)) fault("direction and step change together");
      if (!level(enable_)) fault("a step of a disabled motor");
      if (forbidden != nullptr) fault(forbidden);
      axis.stepped = clock;
      axis.guard_of_step = axis.guard;
      positions_[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(positions_[i]) +
                                                (level(direction) ? ~0u : 1u));
      stepped_ = true;
      ++steps_;
    }
    step_ = step;
    direction_ = direction;
    enable_ = enable;
  }

  void use(std::size_t axis, const Guard& guard) { axis_[axis].guard = guard; }
  Guard guard(std::size_t axis) const { return axis_[axis].guard; }
  void place(std::size_t axis, std::int32_t position) { positions_[axis] = position; }
  const Positions& positions() const { return positions_; }
  bool stepped() const { return stepped_; }
  std::uint64_t steps() const { return steps_; }

 private:
  struct Axis {
    Guard guard, guard_of_step;
    std::uint32_t setup = 0;
    std::uint64_t changed = 0, stepped = 0, turned = 0;
  };

  [[noreturn]] void fault(const std::string& what) const {
    throw PinFault("clock " + std::to_string(clock_) + ", axis " + std::to_string(axis_number_) +
                   ": " + what);
  }
  void want(std::uint64_t clocks, std::uint32_t least, const char* what) const {
    if (clocks < least) {
      fault(std::string(what) + " " + std::to_string(clocks) + " instead of " +
            std::to_string(least));
    }
  }

  std::array<Axis, axes> axis_{};
  Positions positions_{};
  std::uint32_t step_ = 0, direction_ = 0, enable_ = 0;
  std::uint64_t clock_ = 0, steps_ = 0;
  std::size_t axis_number_ = 0;
  bool stepped_ = false;
};

}  // namespace tests
