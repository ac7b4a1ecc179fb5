// SPDX-License-Identifier: Apache-2.0
// Deltas of several sizes, their geometry in floating point, and random places within reach.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "motion/kinematics/any.hpp"
#include "tests/motion/machine.hpp"

namespace motion_test {

using motion::kinematics::Delta;
using motion::kinematics::Place;

inline constexpr double nm = 1e-6;  // in mm
using Vector = std::array<double, 3>;

inline double mm(const units::Position& position) {
  return static_cast<double>(position.whole().count()) * nm + position.femtometers() * 1e-12;
}
inline Vector mm(const Place& place) { return {mm(place[0]), mm(place[1]), mm(place[2])}; }
inline double distance(const Vector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline Delta::Parameters parameters(std::int64_t rod_mm, std::int64_t radius_mm,
                                    std::int64_t printable) {
  constexpr std::int64_t per_mm = 1'000'000;
  Delta::Parameters result{.rod = units::Nanometers(rod_mm * per_mm),
                           .radius = units::Nanometers(radius_mm * per_mm),
                           .height = units::Nanometers(250 * per_mm),
                           .printable_radius = units::Nanometers(printable * per_mm)};
  constexpr std::array<double, 3> degrees{210, 330, 90};
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const double angle = degrees[i] * std::numbers::pi / 180;
    const auto radius = static_cast<double>(result.radius.count());
    result.towers[i] = {.x = units::Nanometers(std::llround(radius * std::cos(angle))),
                        .y = units::Nanometers(std::llround(radius * std::sin(angle)))};
  }
  return result;
}

inline const std::array<Delta::Parameters, 3> deltas{
    parameters(250, 105, 85), parameters(217, 98, 80), parameters(400, 200, 170)};

// By the geometry alone: the carriage's height, with towers at 210, 330 and 90 degrees.
inline double carriage(const Delta::Parameters& delta, std::size_t tower, const Vector& tool) {
  constexpr std::array<double, 3> degrees{210, 330, 90};
  const double angle = degrees[tower] * std::numbers::pi / 180;
  const double radius = static_cast<double>(delta.radius.count()) * nm;
  const double rod = static_cast<double>(delta.rod.count()) * nm;
  const double x = tool[0] - radius * std::cos(angle), y = tool[1] - radius * std::sin(angle);
  return tool[2] + std::sqrt(rod * rod - x * x - y * y);
}

class Places {
 public:
  explicit Places(std::uint64_t seed) : random_(seed) {}
  std::int64_t within(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  Place reached_by(const Delta& delta) {
    const std::int64_t most = delta.parameters().printable_radius.count();
    while (true) {
      const Place place = at(within(-most, most), within(-most, most),
                             within(0, delta.parameters().height.count()), 0);
      if (delta.reaches(place)) return place;
    }
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace motion_test
