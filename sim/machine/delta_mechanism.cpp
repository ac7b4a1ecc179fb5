// SPDX-License-Identifier: Apache-2.0
// The place of the tool as the lower point that has the rods' length from all three carriages.
#include "sim/machine/delta_mechanism.hpp"

#include <cmath>
#include <numbers>

namespace machine {

namespace {

constexpr double nanometers_per_mm = 1e6;
constexpr ExactLength femtometers_per_nanometer = 1'000'000;

using Vector = std::array<double, 3>;

Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector scaled(const Vector& a, double factor) {
  return {a[0] * factor, a[1] * factor, a[2] * factor};
}

// Halves up.
std::int64_t nearest_nanometer(ExactLength length) {
  const ExactLength raised = length + femtometers_per_nanometer / 2;
  ExactLength whole = raised / femtometers_per_nanometer;
  if (raised % femtometers_per_nanometer < 0) --whole;
  return static_cast<std::int64_t>(whole);
}

class DeltaMechanism : public Mechanism {
 public:
  explicit DeltaMechanism(const DeltaProperties& properties) : properties_(properties) {
    constexpr std::array<double, 3> degrees{210, 330, 90};
    for (std::size_t i = 0; i < towers_.size(); ++i) {
      const double angle = degrees[i] * std::numbers::pi / 180;
      const double radius = properties.radius * nanometers_per_mm;
      towers_[i] = {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))};
    }
  }

  Place motors_of(const Place& tool) const override {
    Place motors{};
    for (std::size_t i = 0; i < motors.size(); ++i) {
      const double x = tool[0] - tower(i)[0], y = tool[1] - tower(i)[1];
      motors[i] = tool[2] + std::sqrt(properties_.rod * properties_.rod - x * x - y * y);
    }
    return motors;
  }

  // The centre of the circle through the carriages, and from there down along its axis.
  Place place_of(const Place& motors) const override {
    std::array<Vector, 3> joints{};
    for (std::size_t i = 0; i < joints.size(); ++i) {
      joints[i] = {tower(i)[0], tower(i)[1], motors[i]};
    }
    const Vector a = difference(joints[1], joints[0]), b = difference(joints[2], joints[0]);
    const Vector normal = cross(a, b);
    const double square = product(normal, normal);
    const Vector to_centre =
        scaled(cross(difference(scaled(b, product(a, a)), scaled(a, product(b, b))), normal),
               1 / (2 * square));
    const double radius_square = product(to_centre, to_centre);
    const double down = std::sqrt(std::max(properties_.rod * properties_.rod - radius_square, 0.0));
    const double factor = -down / std::sqrt(square) * (normal[2] < 0 ? -1 : 1);
    Place place{};
    for (std::size_t i = 0; i < place.size(); ++i) {
      place[i] = joints[0][i] + to_centre[i] + factor * normal[i];
    }
    return place;
  }

  ExactPlace exact_motors_of(const ExactPlace& tool) const override {
    const std::int64_t rod = std::llround(properties_.rod * nanometers_per_mm);
    ExactPlace motors{};
    for (std::size_t i = 0; i < motors.size(); ++i) {
      const std::int64_t x = nearest_nanometer(tool[0]) - towers_[i][0];
      const std::int64_t y = nearest_nanometer(tool[1]) - towers_[i][1];
      const std::int64_t square = rod * rod - x * x - y * y;
      const long double root =
          std::sqrt(static_cast<long double>(std::max<std::int64_t>(square, 0)));
      motors[i] = tool[2] + ExactLength{std::llround(root)} * femtometers_per_nanometer;
    }
    return motors;
  }

  double chord_deviation_mm() const override { return 0.01; }
  bool has_own_z() const override { return false; }
  bool homes_all() const override { return true; }
  Place home() const override { return {0, 0, properties_.height}; }
  Place start(const Place& random) const override {
    return {20 * random[0] - 10, 20 * random[1] - 10, properties_.height - 30 - 20 * random[2]};
  }

  devices::SwitchPlace end_stop(std::size_t axis, double steps_per_mm) const override {
    devices::SwitchPlace place;
    place.weights[axis] = -1;
    place.at = -std::llround(end_stop_height(axis) * steps_per_mm);
    return place;
  }

  bool is_beyond_frame(const Place& motors, const Place& travel) const override {
    for (std::size_t i = 0; i < motors.size(); ++i) {
      const double below = end_stop_height(i) - motors[i];
      if (below < -lower_frame_mm || below > travel[i] + upper_frame_mm) return true;
    }
    return place_of(motors)[2] < -lower_frame_mm;
  }

 private:
  Place tower(std::size_t i) const {
    return {static_cast<double>(towers_[i][0]) / nanometers_per_mm,
            static_cast<double>(towers_[i][1]) / nanometers_per_mm, 0};
  }
  double end_stop_height(std::size_t axis) const {
    return motors_of(home())[axis] - properties_.end_stop_offset[axis];
  }

  DeltaProperties properties_;
  std::array<std::array<std::int64_t, 2>, 3> towers_{};  // nm
};

}  // namespace

std::shared_ptr<const Mechanism> delta_mechanism(const DeltaProperties& properties) {
  return std::make_shared<DeltaMechanism>(properties);
}

}  // namespace machine
