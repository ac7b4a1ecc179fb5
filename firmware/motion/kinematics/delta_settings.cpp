// SPDX-License-Identifier: Apache-2.0
// Ranges of the parameters, each by itself and together.
#include "motion/kinematics/delta_settings.hpp"

#include "motion/rotation.hpp"
#include "units/loop_bound.hpp"

namespace motion::kinematics {

namespace {

using units::Nanometers;

constexpr std::int64_t nanometers_per_mm = 1'000'000;
constexpr std::int64_t millionths = 1'000'000;
constexpr Nanometers shortest{nanometers_per_mm}, longest{1'000 * nanometers_per_mm};
constexpr Nanometers most_trim{10 * nanometers_per_mm};
constexpr std::int32_t most_turn = 10 * millionths;
constexpr std::array<std::int32_t, spatial_axes> degrees{210, 330, 90};

bool within(Nanometers value, Nanometers least, Nanometers most) {
  return value >= least && value <= most;
}

}  // namespace

void place_towers(Delta::Parameters& delta) {
  constexpr std::int64_t turn = 360 * millionths;
  constexpr int bits = 30;  // of cosine and sine
  units::LoopBound<spatial_axes> towers;
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    towers.next();
    const std::int64_t direction = degrees[i] * millionths + delta.angle_trim[i];
    const Rotation rotation = rotation_by(static_cast<Angle>((direction << 32) / turn));
    const auto part = [&](std::int64_t of_one) {
      return Nanometers((delta.radius.count() * of_one + (std::int64_t{1} << (bits - 1))) >> bits);
    };
    delta.towers[i] = {.x = part(rotation.cosine), .y = part(rotation.sine)};
  }
}

std::string_view fault_of(const Delta::Parameters& delta) {
  if (!within(delta.height, shortest, longest)) return "H not within 1 to 1000 mm";
  if (!within(delta.radius, shortest, longest)) return "R not within 1 to 1000 mm";
  if (!within(delta.rod, shortest, longest)) return "L not within 1 to 1000 mm";
  units::LoopBound<spatial_axes, 1> towers;
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    towers.next();
    if (delta.angle_trim[i] < -most_turn || delta.angle_trim[i] > most_turn) {
      return "X, Y or Z not within -10 to 10 degrees";
    }
    if (!within(delta.rod_trim[i], -most_trim, most_trim)) {
      return "A, B or C not within -10 to 10 mm";
    }
    if (!within(delta.end_stop_offset[i], -most_trim, Nanometers())) {
      return "M666 offsets must be <= 0 and >= -10 mm";
    }
    const Nanometers rod = delta.rod + delta.rod_trim[i];
    if (!within(rod, shortest, longest)) return "Rods with their trims not within 1 to 1000 mm";
    const Nanometers flattest = delta.radius + delta.printable_radius;
    if (flattest.count() * 100 > rod.count() * 95) {
      return "L too short: rods would lie flat at the edge of the bed";
    }
    if (delta.radius.count() * 100 < rod.count() * 31) {
      return "L too long: rods would stand upright";
    }
  }
  if (delta.printable_radius >= delta.radius) return "R not above the radius of the bed";
  return {};
}

}  // namespace motion::kinematics
