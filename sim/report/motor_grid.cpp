// SPDX-License-Identifier: Apache-2.0
// Exact places through the mechanism, and steps there and back along moves.
#include "sim/report/motor_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace report {

namespace {

constexpr std::size_t height = 2;
constexpr double samples_per_mm = 2;
constexpr int least_samples = 32, least_samples_of_arc = 1024;

int samples_of(const Move& move) {
  std::array<double, 3> way{};
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = millimeters(move.to[i] - move.from[i]);
  const double length =
      std::hypot(way[0], way[1], way[2]) + (move.arc ? move.arc->length_mm() : 0.0);
  return std::max(move.arc ? least_samples_of_arc : least_samples,
                  static_cast<int>(samples_per_mm * length));
}

}  // namespace

HomePlace home_of(const machine::Mechanism& mechanism) {
  HomePlace home{.of_all_axes = mechanism.homes_all()};
  const machine::Mechanism::Place place = mechanism.home();
  for (std::size_t i = 0; i < place.size(); ++i) {
    constexpr double nanometers_per_mm = 1e6;  // the finest of a description
    home.place[i] = Femtometers{std::llround(place[i] * nanometers_per_mm)} * 1'000'000;
  }
  return home;
}

MotorGrid::Steps MotorGrid::steps_at(const Point& place) const {
  const auto motors = mechanism_->exact_motors_of({place[0], place[1], place[2]});
  Steps steps{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] = origin_[i] + nearest_step(i < motors.size() ? motors[i] : place[i], resolution_[i]);
  }
  return steps;
}

// So that the motors, which stand at these steps, are at this place.
void MotorGrid::move_origin(const Point& place, const Steps& steps) {
  const Steps expected = steps_at(place);
  for (std::size_t i = 0; i < 3; ++i) origin_[i] += steps[i] - expected[i];
}

std::array<double, 3> MotorGrid::place_mm(const Steps& steps) const {
  std::array<double, 3> motors{};
  for (std::size_t i = 0; i < motors.size(); ++i) {
    motors[i] = static_cast<double>(steps[i] - origin_[i]) / steps_per_mm(i);
  }
  return mechanism_->place_of(motors);
}

Point MotorGrid::place_of_steps(const Steps& steps) const {
  Point place{};
  for (std::size_t i = 0; i < place.size(); ++i) {
    place[i] = place_of_step(steps[i] - origin_[i], resolution_[i]);
  }
  if (mechanism_->is_cartesian()) return place;
  const std::array<double, 3> tool = place_mm(steps);
  for (std::size_t i = 0; i < tool.size(); ++i) {
    place[i] = static_cast<Femtometers>(tool[i] * static_cast<double>(femtometers_per_mm));
  }
  return place;
}

double MotorGrid::step_mm(const std::array<double, 3>& place) const {
  return mechanism_->gain_at(place) / std::min(steps_per_mm(0), steps_per_mm(1));
}

std::array<double, motor_count> MotorGrid::motors_on(const Move& move, double part) const {
  const auto motors = mechanism_->motors_of(move.place_mm(part));
  std::array<double, motor_count> steps{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double from = millimeters(move.from[i]), to = millimeters(move.to[i]);
    const double place = i < motors.size() ? motors[i] : from + part * (to - from);
    steps[i] = static_cast<double>(origin_[i]) + place * steps_per_mm(i);
  }
  return steps;
}

MotorGrid::Steps MotorGrid::detour_of(const Move& move) const {
  if (!mechanism_->is_cartesian()) return sampled_detour_of(move);
  Steps detour = move.arc ? detour_of_arc(move) : Steps{};
  // Besides, a Z next to the nearest step.
  if (move.mesh) detour[height] = sampled_detour_of(move)[height] + 2;
  return detour;
}

// By where its axes turn back.
MotorGrid::Steps MotorGrid::detour_of_arc(const Move& move) const {
  Steps detour{};
  for (const std::size_t side : {0UZ, 1UZ}) {
    const std::size_t axis = side == 0 ? move.arc->first : move.arc->second;
    const auto step_at = [&](double part) {
      return std::llround(move.arc->at(part)[side] * steps_per_mm(axis));
    };
    std::int64_t before = step_at(0);
    detour[axis] = -std::llabs(step_at(1) - before);
    std::vector<double> parts = move.arc->turning_points();
    parts.push_back(1);
    for (const double part : parts) {
      detour[axis] += std::llabs(step_at(part) - before);
      before = step_at(part);
    }
  }
  return detour;
}

MotorGrid::Steps MotorGrid::sampled_detour_of(const Move& move) const {
  Steps detour{};
  std::array<int, 3> direction{};
  const int samples = samples_of(move);
  const auto steps_of = [&](int sample) {
    const auto motors = mechanism_->motors_of(move.place_mm(static_cast<double>(sample) / samples));
    std::array<std::int64_t, 3> steps{};
    for (std::size_t i = 0; i < steps.size(); ++i) {
      steps[i] = std::llround(motors[i] * steps_per_mm(i));
    }
    return steps;
  };
  const auto start = steps_of(0);
  auto before = start;
  for (int sample = 1; sample <= samples; ++sample) {
    const auto here = steps_of(sample);
    for (std::size_t i = 0; i < here.size(); ++i) {
      const std::int64_t way = here[i] - before[i];
      detour[i] += std::llabs(way);
      const int towards = way < 0 ? -1 : way > 0 ? 1 : direction[i];
      // Between two samples it may have gone on and come back.
      if (towards != direction[i] && direction[i] != 0) detour[i] += 2;
      direction[i] = towards;
    }
    before = here;
  }
  for (std::size_t i = 0; i < before.size(); ++i) detour[i] -= std::llabs(before[i] - start[i]);
  return detour;
}

}  // namespace report
