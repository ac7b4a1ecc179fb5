// SPDX-License-Identifier: Apache-2.0
// The arms' directions by the law of cosines, the place of the tool by adding up the arms.
#include "sim/machine/scara_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace machine {

namespace {

using Real = long double;
using Directions = std::array<Real, 2>;  // degrees

constexpr Real turn = 360;
constexpr Real units_per_degree = 1e12L;  // of ExactLength
constexpr Real femtometers_per_mm = 1e12L;
// The arms lie on top of each other or in line, and touch their stops before.
constexpr double least_elbow = 3, most_elbow = 177;

Real degrees(Real radians) { return radians * 180 / std::numbers::pi_v<Real>; }

class ScaraMechanism : public Mechanism {
 public:
  explicit ScaraMechanism(const ScaraProperties& properties) : properties_(properties) {}

  Place motors_of(const Place& tool) const override {
    const Directions arms = directions(tool[0], tool[1]);
    return {static_cast<double>(arms[0]), static_cast<double>(arms[1]), tool[2]};
  }

  Place place_of(const Place& motors) const override {
    const double first = motors[0] * std::numbers::pi / 180;
    const double second = motors[1] * std::numbers::pi / 180;
    return {properties_.shoulder[0] + properties_.proximal * std::cos(first) +
                properties_.distal * std::cos(second),
            properties_.shoulder[1] + properties_.proximal * std::sin(first) +
                properties_.distal * std::sin(second),
            motors[2]};
  }

  ExactPlace exact_motors_of(const ExactPlace& tool) const override {
    const Directions arms = directions(static_cast<Real>(tool[0]) / femtometers_per_mm,
                                       static_cast<Real>(tool[1]) / femtometers_per_mm);
    return {ExactLength{std::llround(arms[0] * units_per_degree)},
            ExactLength{std::llround(arms[1] * units_per_degree)}, tool[2]};
  }

  double chord_deviation_mm() const override { return 0.01; }
  bool homes_all() const override { return true; }
  Place home() const override {
    return {properties_.home[0], properties_.home[1], properties_.height};
  }
  Place start(const Place& random) const override {
    return {home()[0] + 20 * random[0] - 10, home()[1] + 20 * random[1] - 10,
            properties_.height - 10 - 20 * random[2]};
  }

  // The way from an end stop to home is made of whole steps: so is the end stop's place.
  devices::SwitchPlace end_stop(std::size_t axis, double steps_per_mm) const override {
    const double at_home = motors_of(home())[axis];
    const double behind = at_home - end_stop_at(axis);
    devices::SwitchPlace place;
    place.weights[axis] = -1;
    place.at = -(std::llround(at_home * steps_per_mm) - std::llround(behind * steps_per_mm));
    return place;
  }

  bool is_beyond_frame(const Place& motors, const Place& travel) const override {
    for (std::size_t i = 0; i < motors.size(); ++i) {
      const double below = end_stop_at(i) - motors[i];
      if (below < -lower_frame_mm || below > travel[i] + upper_frame_mm) return true;
    }
    const double elbow = properties_.elbow_left ? motors[0] - motors[1] : motors[1] - motors[0];
    return elbow < least_elbow || elbow > most_elbow || motors[2] < -lower_frame_mm;
  }

 private:
  double end_stop_at(std::size_t axis) const {
    return axis < properties_.end_stop.size() ? properties_.end_stop[axis] : properties_.height;
  }

  // Between the arm, which has the first of these sides, and the way to the tool.
  static Real angle_at(Real side, Real other, Real away) {
    return std::acos(std::clamp((away * away + side * side - other * other) / (2 * away * side),
                                Real{-1}, Real{1}));
  }

  Directions directions(Real x, Real y) const {
    const Real a = properties_.proximal, b = properties_.distal;
    x -= properties_.shoulder[0];
    y -= properties_.shoulder[1];
    const Real away = std::hypot(x, y), towards = std::atan2(y, x);
    const Real side = properties_.elbow_left ? 1 : -1;
    Directions arms{degrees(towards + side * angle_at(a, b, away)),
                    degrees(towards - side * angle_at(b, a, away))};
    for (std::size_t i = 0; i < arms.size(); ++i) {
      // In the turn that ends 10 degrees beyond the end stop.
      constexpr Real beyond = 10;
      const Real most = properties_.end_stop[i] + beyond;
      arms[i] -= turn * std::ceil((arms[i] - most) / turn);
    }
    return arms;
  }

  ScaraProperties properties_;
};

}  // namespace

std::shared_ptr<const Mechanism> scara_mechanism(const ScaraProperties& properties) {
  return std::make_shared<ScaraMechanism>(properties);
}

}  // namespace machine
