// SPDX-License-Identifier: Apache-2.0
// The play of drives: a motor that turns back takes it up before its axis moves. It is no part of
// any position: motors are ahead of their axes by it.
#pragma once

#include <array>
#include <cstdint>

#include "motion/limits.hpp"
#include "units/axes.hpp"
#include "units/quantity.hpp"

namespace motion {

// Whether the machine of this image compensates it: a constant of the program, so that the linker
// leaves out what it does not have. On a host it is true.
extern const bool backlash_in_image;

struct BacklashSettings {
  static constexpr std::size_t axes = 3;  // X, Y, Z
  static constexpr units::Nanometers longest{5'000'000};
  static constexpr std::uint32_t whole = 1'000'000;

  std::array<units::Nanometers, axes> lengths{};  // 0 to `longest`
  std::uint32_t correction{whole};  // the part of it that is taken up, in millionths
};

class Backlash {
 public:
  void configure(const BacklashSettings& settings, const Limits& limits);
  const BacklashSettings& settings() const { return settings_; }
  // Steps per millimetre may be others.
  void set_limits(const Limits& limits);

  // Of the way of a motor's axis, in steps: what the motor makes besides, in the same direction.
  std::int32_t steps_before(std::size_t motor, std::int64_t way) const {
    const bool back = way < 0;
    if (way == 0 || back == is_back(motor)) return 0;
    return back ? -steps_[motor] : steps_[motor];
  }
  // The length of these steps.
  units::Nanometers length_of(std::size_t motor, std::int64_t steps) const {
    if (steps == 0) return {};
    return steps < 0 ? -lengths_[motor] : lengths_[motor];
  }
  // The motor is given a line with this way.
  void turn(std::size_t motor, std::int64_t way) {
    if (way == 0) return;
    const auto axis = static_cast<units::Axis>(motor);
    way < 0 ? back_.insert(axis) : back_.remove(axis);
  }
  // How far it is ahead of its axis after that, in steps.
  std::int32_t lead(std::size_t motor) const { return is_back(motor) ? -steps_[motor] : 0; }

 private:
  bool is_back(std::size_t motor) const { return back_.contains(static_cast<units::Axis>(motor)); }

  BacklashSettings settings_{};
  // What is taken up. E has none.
  units::PerAxis<std::int32_t> steps_{};
  units::PerAxis<units::Nanometers> lengths_{};
  units::AxisSet back_;  // motors whose last way was towards lower places
};

}  // namespace motion
