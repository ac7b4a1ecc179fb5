// SPDX-License-Identifier: Apache-2.0
// The machine under test: limits of a Prusa Mendel, built in code to be free of
// the description's changes.
#pragma once

#include "motion/limits.hpp"
#include "motion/line.hpp"

namespace motion_test {

constexpr motion::AxisLimits axis_limits(std::int32_t steps_per_meter, std::int64_t travel_mm,
                                         std::int32_t speed_mm_s, std::int32_t acceleration_mm_s2,
                                         std::int32_t jerk_um_s) {
  return {.steps_per_meter = units::StepsPerMeter(steps_per_meter),
          .travel = units::Nanometers(travel_mm * 1'000'000),
          .max_speed = units::MicrometersPerSecond(speed_mm_s * 1'000),
          .max_acceleration = units::MicrometersPerSecondSquared(acceleration_mm_s2 * 1'000),
          .jerk = units::MicrometersPerSecond(jerk_um_s)};
}

constexpr motion::HomingParameters homing(std::int32_t fast_mm_s, std::int32_t slow_mm_s,
                                          std::int64_t back_off_mm, std::uint8_t end_stop) {
  return {.fast_speed = units::MicrometersPerSecond(fast_mm_s * 1'000),
          .slow_speed = units::MicrometersPerSecond(slow_mm_s * 1'000),
          .back_off = units::Nanometers(back_off_mm * 1'000'000),
          .end_stop = end_stop};
}

constexpr motion::Limits mendel() {
  motion::Limits limits{.axes = {axis_limits(80'000, 200, 200, 3'000, 10'000),
                                 axis_limits(80'000, 200, 200, 3'000, 10'000),
                                 axis_limits(2'560'000, 110, 12, 500, 400),
                                 axis_limits(500'000, 0, 80, 10'000, 2'500)},
                        .print_acceleration = units::MicrometersPerSecondSquared(1'500'000),
                        .travel_acceleration = units::MicrometersPerSecondSquared(1'500'000),
                        .retract_acceleration = units::MicrometersPerSecondSquared(1'500'000)};
  limits.of(units::Axis::x).homing = homing(50, 5, 5, 0);
  limits.of(units::Axis::y).homing = homing(50, 5, 5, 1);
  limits.of(units::Axis::z).homing = homing(8, 1, 2, 2);
  return limits;
}

// A4988: 1 us + 1 us.
constexpr motion::StepTiming timing(std::uint32_t clock_hz,
                                    units::Microseconds least_line_time = {}) {
  const units::Hertz rate(500'000);
  return {.clock = units::Hertz(clock_hz),
          .max_step_rate = {rate, rate, rate, rate},
          .least_line_time = least_line_time};
}

constexpr units::PerAxis<units::Position> at(std::int64_t x_nm, std::int64_t y_nm,
                                             std::int64_t z_nm, std::int64_t e_nm) {
  return {units::Nanometers(x_nm), units::Nanometers(y_nm), units::Nanometers(z_nm),
          units::Nanometers(e_nm)};
}

}  // namespace motion_test
