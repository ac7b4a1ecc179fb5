// SPDX-License-Identifier: Apache-2.0
// Mechanisms whose motors move the tool along straight lines.
#include "sim/machine/mechanism.hpp"

#include <algorithm>
#include <cmath>

namespace machine {

namespace {

class CartesianMechanism : public Mechanism {
 public:
  bool is_cartesian() const override { return true; }
  Place motors_of(const Place& tool) const override { return tool; }
  Place place_of(const Place& motors) const override { return motors; }
  ExactPlace exact_motors_of(const ExactPlace& tool) const override { return tool; }
  double gain_at(const Place&) const override { return 1; }
  devices::SwitchPlace end_stop(std::size_t axis, double) const override {
    devices::SwitchPlace place;
    place.weights[axis] = 1;
    return place;
  }
};

// The belts cross: one motor pulls both axes forward, the other one X forward and Y back.
class CoreXyMechanism : public Mechanism {
 public:
  Place motors_of(const Place& tool) const override {
    return {tool[0] + tool[1], tool[0] - tool[1], tool[2]};
  }
  Place place_of(const Place& motors) const override {
    return {(motors[0] + motors[1]) / 2, (motors[0] - motors[1]) / 2, motors[2]};
  }
  ExactPlace exact_motors_of(const ExactPlace& tool) const override {
    return {tool[0] + tool[1], tool[0] - tool[1], tool[2]};
  }
  double gain_at(const Place&) const override { return 1; }
  devices::SwitchPlace end_stop(std::size_t axis, double) const override {
    if (axis == 0) return {.weights = {1, 1, 0, 0}};
    if (axis == 1) return {.weights = {1, -1, 0, 0}};
    return {.weights = {0, 0, 1, 0}};
  }
};

}  // namespace

double Mechanism::gain_at(const Place& tool) const {
  constexpr double small = 1e-3;
  const Place motors = motors_of(tool);
  double gain = 0;
  for (std::size_t i = 0; i < motors.size(); ++i) {
    Place moved = motors;
    moved[i] += small;
    const Place reached = place_of(moved);
    gain = std::max(gain,
                    std::hypot(reached[0] - tool[0], reached[1] - tool[1], reached[2] - tool[2]));
  }
  return gain / small;
}

Mechanism::Place Mechanism::start(const Place& random) const {
  constexpr double least_mm = 2.0;
  constexpr Place most_mm{40.0, 40.0, 8.0};
  Place place{};
  for (std::size_t i = 0; i < place.size(); ++i) {
    place[i] = least_mm + (most_mm[i] - least_mm) * random[i];
  }
  return place;
}

bool Mechanism::is_beyond_frame(const Place& motors, const Place& travel) const {
  const Place place = place_of(motors);
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] < -lower_frame_mm || place[i] > travel[i] + upper_frame_mm) return true;
  }
  return false;
}

std::shared_ptr<const Mechanism> cartesian_mechanism() {
  static const auto mechanism = std::make_shared<CartesianMechanism>();
  return mechanism;
}

std::shared_ptr<const Mechanism> core_xy_mechanism() {
  static const auto mechanism = std::make_shared<CoreXyMechanism>();
  return mechanism;
}

}  // namespace machine
