// SPDX-License-Identifier: Apache-2.0
// An ideal printer whose steps the judge sees, line by line.
#pragma once

#include <gmock/gmock.h>

#include <cmath>

#include "sim/report/point_check.hpp"

namespace tests {

// Walks each command's line with single steps along the ideal positions.
class PointCheckTest : public testing::Test {
 protected:
  static constexpr std::array<double, 4> steps_per_mm{80, 80, 2560, 500};

  explicit PointCheckTest(const report::MachineFacts& facts = {})
      : check(steps_per_mm, {1234, 567, 0, 0}, sim::ClockRate(4'000'000), facts) {}

  void send(const std::string& command, bool executed = true) {
    begin(command);
    if (executed && command.starts_with("G28")) go_to(0, 0);
    end(executed);
  }
  void begin(const std::string& command) { check.command_sent(++clock, ++file_line, command); }
  void end(bool executed = true) { check.command_acknowledged(++clock, file_line, "", executed); }

  void step(std::size_t axis, int direction) {
    position[axis] += direction;
    check.stepped({clock, axis, direction, position[axis]});
  }
  // In small steps along the line, like a Bresenham walk. E and Z stay where they are if not given.
  void go_to(double x_mm, double y_mm) {
    go_to(steps(0, x_mm), steps(1, y_mm), position[2], position[3]);
  }
  void go_to(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t e) {
    const report::Steps from = position, to{x, y, z, e};
    std::int64_t ticks = 0;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      ticks = std::max(ticks, std::abs(to[axis] - from[axis]));
    }
    for (std::int64_t tick = 1; tick <= ticks; ++tick) {
      clock += 100;
      for (std::size_t axis = 0; axis < 4; ++axis) {
        const auto ideal =
            static_cast<double>((to[axis] - from[axis]) * tick) / static_cast<double>(ticks);
        const std::int64_t next = from[axis] + std::llround(ideal);
        if (next != position[axis]) step(axis, next > position[axis] ? 1 : -1);
      }
    }
  }
  static std::int64_t steps(std::size_t axis, double mm) {
    return std::llround(mm * steps_per_mm[axis]);
  }
  std::uint64_t reached() const { return check.judgement().reached; }
  std::uint64_t missed() const { return check.judgement().missed; }
  report::Steps unasked() const { return check.judgement().unasked_steps; }

  report::Steps position{1234, 567, 0, 0};
  std::uint64_t clock = 0;
  std::size_t file_line = 0;
  report::PointCheck check;
};

}  // namespace tests
