// SPDX-License-Identifier: Apache-2.0
// How fast the scale of time may change without exceeding the acceleration limits of any
// planned line.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "motion/limits.hpp"
#include "units/quantity.hpp"

namespace application {

// At a scale s a line with speed v and acceleration a is made with s^2 a + (ds/dt) v. With
// |ds/dt| v <= A for every A that a line must keep to (M204 along its path, M201 of each axis) the
// step generator keeps that sum within A: it slows the change where both terms have one sign
// (rtl/motion/feed_override.vhd). So the slope is the least A / v of all lines that may still be
// executed, each with the limits that it was planned under.
class Slope {
 public:
  // At most `most_lines` are planned and not yet done.
  Slope(units::Hertz clock, std::uint32_t most_lines) : clock_(clock), most_lines_(most_lines) {}

  // For lines that are planned from now on.
  void set_limits(const motion::Limits& limits);
  // A line is planned. Returns the slope if it has changed by that, in 2^-32 per clock.
  std::optional<std::uint32_t> note_line(units::MicrometersPerSecond feedrate);
  // All lines planned before have been executed.
  void note_rest() {
    before_ = here_ = {};
    lines_here_ = 0;
  }

 private:
  // Of a group of lines.
  struct Strictest {
    std::uint32_t speed{};  // um/s, along the path
    std::uint32_t acceleration{std::numeric_limits<std::uint32_t>::max()};  // um/s^2, M204
    std::uint32_t axis_slope{std::numeric_limits<std::uint32_t>::max()};  // by M201 and M203

    void include(const Strictest& other);
    bool operator==(const Strictest&) const = default;
  };

  std::uint32_t slope_of(const Strictest& lines) const;

  units::Hertz clock_;
  std::uint32_t most_lines_;
  Strictest limits_;  // with a speed that no path can exceed
  std::uint32_t least_speed_{};  // um/s, M205
  // Lines are forgotten in groups of `most_lines`: the present one, and the one before it.
  Strictest here_, before_;
  std::uint32_t lines_here_{};
  std::optional<Strictest> in_force_;
};

}  // namespace application
