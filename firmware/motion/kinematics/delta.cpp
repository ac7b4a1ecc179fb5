// SPDX-License-Identifier: Apache-2.0
// The delta's geometry in whole nanometres.
#include "motion/kinematics/delta.hpp"

#include <algorithm>

#include "motion/kinematics/lengths.hpp"
#include "motion/kinematics/square_root.hpp"
#include "motion/scaled.hpp"
#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"

namespace motion::kinematics {

namespace {

using units::magnitude;
using units::Nanometers;

// A carriage may leave the height for a straight line by so much in the middle of a chord. Within
// the printable radius the tool then leaves its line by less than chord_deviation.
constexpr std::uint64_t carriage_deviation = 8'000;
constexpr std::uint32_t least_rise = 1'000'000;
// No bed is so far below its place: lengths stay below what their squares permit.
constexpr units::Position lowest{Nanometers(-1'000'000'000)};

std::uint32_t narrow(Nanometers length) { return static_cast<std::uint32_t>(length.count()); }

}  // namespace

std::uint32_t Delta::rise(std::size_t tower, Nanometers x, Nanometers y) const {
  const std::uint64_t away = square((x - parameters_.towers[tower].x).count()) +
                             square((y - parameters_.towers[tower].y).count());
  const std::uint64_t rod = square(this->rod(tower).count());
  return away < rod ? nearest_root(rod - away) : 0;
}

// Between two places a carriage is lowest above the tool at one of them: the distance from a tower
// is convex along a line.
std::uint32_t Delta::lowest_rise(const Place& from, const Place& to) const {
  std::uint32_t least = ~std::uint32_t{0};
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    for (const Place* place : {&from, &to}) {
      least = std::min(least, rise(i, (*place)[0].nearest(), (*place)[1].nearest()));
    }
  }
  return std::max(least, least_rise);
}

// The rise of a carriage above the tool is concave, so it lies below its tangent above the origin,
// whose slope is radius / rise: with the shortest rods the steepest one.
bool Delta::reaches(const Place& tool) const {
  const Nanometers most = parameters_.printable_radius;
  for (const std::size_t i : {0UZ, 1UZ}) {
    if (tool[i] > most || -tool[i] > most) return false;
  }
  const std::uint64_t away = square(tool[0].nearest().count()) + square(tool[1].nearest().count());
  if (away > square(most.count()) || tool[2] < lowest) return false;
  const Nanometers room = parameters_.height - tool[2].nearest();
  const std::uint64_t rise =
      nearest_root(square(shortest_rod().count()) - square(parameters_.radius.count()));
  return room >= Nanometers(0) &&
         (room > longest_rod() ||
          magnitude(room.count()) * rise >=
              std::uint64_t{narrow(parameters_.radius)} * nearest_root(away));
}

Place Delta::motors_of(const Place& tool) const {
  Place motors = tool;
  const Nanometers x = tool[0].nearest(), y = tool[1].nearest();
  for (std::size_t i = 0; i < spatial_axes; ++i) motors[i] = tool[2] + Nanometers(rise(i, x, y));
  return motors;
}

Place Delta::place_of(const Place& motors) const {
  constexpr int bits = 14;  // of slopes
  // So that products fit. Bits of a difference of two carriages, and of squares of X and Y.
  constexpr std::int64_t furthest_off = std::int64_t{1} << 28;
  constexpr std::int64_t furthest = std::int64_t{1} << 30;
  const std::int64_t most = parameters_.printable_radius.count();
  std::int64_t x = 0, y = 0;
  std::int64_t z = motors[0].nearest().count() - rise(0, Nanometers(0), Nanometers(0));
  constexpr std::uint32_t most_rounds = 10;
  units::LoopBound<most_rounds> rounds;
  for (std::uint32_t round = 0; round < most_rounds; ++round) {
    rounds.next();
    std::array<std::int64_t, spatial_axes> off, slope_x, slope_y;
    bool arrived = true;
    for (std::size_t i = 0; i < spatial_axes; ++i) {
      const std::int64_t height = std::max(rise(i, Nanometers(x), Nanometers(y)), least_rise);
      off[i] = std::clamp(motors[i].nearest().count() - z - height, -furthest_off, furthest_off);
      slope_x[i] = (parameters_.towers[i].x.count() - x) * (1 << bits) / height;
      slope_y[i] = (parameters_.towers[i].y.count() - y) * (1 << bits) / height;
      arrived = arrived && off[i] == 0;
    }
    if (arrived) break;
    const std::int64_t x1 = slope_x[1] - slope_x[0], x2 = slope_x[2] - slope_x[0];
    const std::int64_t y1 = slope_y[1] - slope_y[0], y2 = slope_y[2] - slope_y[0];
    const std::int64_t determinant = x1 * y2 - x2 * y1;
    if (determinant == 0) break;
    const std::int64_t off1 = off[1] - off[0], off2 = off[2] - off[0];
    const std::int64_t step_x = (off1 * y2 - off2 * y1) * (1 << bits) / determinant;
    const std::int64_t step_y = (off2 * x1 - off1 * x2) * (1 << bits) / determinant;
    z += off[0] - ((slope_x[0] * step_x + slope_y[0] * step_y) >> bits);
    x = std::clamp(x + step_x, -furthest, furthest);
    y = std::clamp(y + step_y, -furthest, furthest);
    // Where no rod is flat the method converges: back onto the printable circle.
    const std::int64_t away = nearest_root(square(x) + square(y));
    if (away <= most) continue;
    x = x * most / away;
    y = y * most / away;
  }
  return {Nanometers(x), Nanometers(y), Nanometers(z), motors[3]};
}

// With the way w in XY and the rise h, the height of a carriage has a second derivative of at most
// rod^2 / h^3 by w, and its middle leaves a chord of w by rod^2 w^2 / (8 h^3). The longest rods and
// the least rise are those of the worst carriage, or worse.
std::uint32_t Delta::chords(const Place& from, const Place& to) const {
  const Scaled rise = Scaled::of(lowest_rise(from, to));
  const Scaled way = Scaled::of(horizontal_length(from, to)) * Scaled::of(narrow(longest_rod()));
  const Scaled by_deviation =
      way / (Scaled::of(8 * carriage_deviation) * rise * rise * rise).square_root();
  return static_cast<std::uint32_t>(by_deviation.floor()) + 1;
}

// v^2 w^2 / l^2 * rod^2 / h^3 <= most
units::MicrometersPerSecond Delta::speed_limit(const Place& from, const Place& to,
                                               units::MicrometersPerSecondSquared most) const {
  const std::uint32_t way = horizontal_length(from, to);
  if (way == 0) return max_speed;
  const Scaled rise = Scaled::of(lowest_rise(from, to));
  const Scaled share =
      spatial_length(from, to) / (Scaled::of(way) * Scaled::of(narrow(longest_rod())));
  const Scaled square =
      Scaled::of(magnitude(most.count())) * rise * rise * rise * share * share / Scaled::of(1'000);
  const std::uint64_t speed = square.square_root().floor();
  return units::MicrometersPerSecond(
      static_cast<std::int32_t>(std::clamp<std::uint64_t>(speed, 1, magnitude(max_speed.count()))));
}

Home Delta::home() const {
  Home home;
  home.tool[2] = parameters_.height;
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    home.behind_end_stop[i] = parameters_.end_stop_offset[i];
  }
  return home;
}

}  // namespace motion::kinematics
