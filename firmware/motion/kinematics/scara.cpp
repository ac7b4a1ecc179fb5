// SPDX-License-Identifier: Apache-2.0
// The triangle of shoulder, elbow and tool in whole nanometres, angles in parts of a turn.
#include "motion/kinematics/scara.hpp"

#include <algorithm>

#include "motion/kinematics/lengths.hpp"
#include "motion/kinematics/square_root.hpp"
#include "motion/rotation.hpp"
#include "motion/scaled.hpp"
#include "units/magnitude.hpp"

namespace motion::kinematics {

namespace {

using units::magnitude;
using units::Nanometers;

// What the path may leave its chord by, below chord_deviation: the places are rounded.
constexpr std::uint64_t path_deviation = 9'000;
// The machine generator keeps the arms at least 10 degrees from stretched and folded, where the
// sine of the elbow's angle is 0.17; no less is calculated with.
constexpr std::uint32_t lowest_sine = (std::uint32_t{1} << 30) / 8;
constexpr int sine_bits = 30;
constexpr std::int64_t most_coordinate = (std::int64_t{1} << 30) - 1;  // of a Vector
constexpr units::Position lowest{Nanometers(-1'000'000'000)};

constexpr std::int64_t turn = 360'000'000;  // in millionths of a degree
constexpr std::int64_t beyond_end_stop = 10'000'000;

// Halves away from 0.
std::int64_t nearest_quotient(std::int64_t dividend, std::int64_t divisor) {
  const std::int64_t half = divisor / 2;
  return (dividend < 0 ? dividend - half : dividend + half) / divisor;
}

std::int32_t direction_of(std::int64_t x, std::int64_t y) {
  constexpr Vector east{1 << 29, 0};
  const Angle angle =
      angle_between(east, {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)});
  return static_cast<std::int32_t>((angle * std::uint64_t{turn} + (1U << 31)) >> 32);
}

// Of 0 .. turn, in the turn that ends 10 degrees beyond the end stop.
Nanometers in_turn_of(std::int64_t direction, Nanometers end_stop) {
  const std::int64_t most = end_stop.count() + beyond_end_stop;
  if (direction > most) direction -= turn;
  if (direction > most) direction -= turn;
  return Nanometers(direction);
}

Vector arm(Nanometers length, const units::Position& direction) {
  const std::int64_t part = direction.nearest().count() % turn;
  const std::int64_t angle = nearest_quotient(part * (std::int64_t{1} << 32), turn);
  return turned({static_cast<std::int32_t>(length.count()), 0}, static_cast<Angle>(angle));
}

Scaled of(Nanometers length) { return Scaled::of_word(static_cast<std::uint32_t>(length.count())); }

}  // namespace

Scara::Flat Scara::from_shoulder(const Place& tool) const {
  const auto clamped = [](Nanometers length) {
    return std::clamp(length.count(), -most_coordinate, most_coordinate);
  };
  return {.x = clamped(tool[0].nearest() - parameters_.shoulder_x),
          .y = clamped(tool[1].nearest() - parameters_.shoulder_y)};
}

bool Scara::within(const Place& tool, Nanometers beyond) const {
  const std::array<Nanometers, 2> ends{parameters_.width, parameters_.depth};
  for (const std::size_t i : {0UZ, 1UZ}) {
    if (tool[i] < units::Position(-beyond) || tool[i] > units::Position(ends[i] + beyond)) {
      return false;
    }
  }
  if (tool[2] < lowest || tool[2] > units::Position(parameters_.height + beyond)) return false;
  const Flat here = from_shoulder(tool);
  const std::uint64_t away = square(here.x) + square(here.y);
  return away >= square((parameters_.inner_radius - beyond).count()) &&
         away <= square((parameters_.outer_radius + beyond).count());
}

bool Scara::reaches(const Place& tool) const { return within(tool, slack); }

bool Scara::straight_within(const Place& from, const Place& to) const {
  if (!within(to, Nanometers(0))) return false;
  const Flat begin = from_shoulder(from), end = from_shoulder(to);
  // From a place too near, lines lead only away.
  const std::uint64_t least = squares(begin, end).least;
  return least >= square(parameters_.inner_radius.count()) ||
         least == square(begin.x) + square(begin.y);
}

// Nearest at the foot of the perpendicular, if that is on the line.
Scara::Span Scara::squares(const Flat& from, const Flat& to) {
  const std::uint64_t first = square(from.x) + square(from.y);
  const std::uint64_t last = square(to.x) + square(to.y);
  Span span{.least = std::min(first, last), .most = std::max(first, last)};
  const std::int64_t x = to.x - from.x, y = to.y - from.y;
  const std::int64_t to_foot = -(from.x * x + from.y * y);
  const std::uint64_t length = square(x) + square(y);
  if (to_foot <= 0 || static_cast<std::uint64_t>(to_foot) >= length) return span;
  const Scaled area = Scaled::of(magnitude(from.x * y - from.y * x));
  const std::uint64_t distance = (area / Scaled::of(length).square_root()).floor();
  span.least = std::min(span.least, distance * distance);
  return span;
}

// The elbow lies on its side of the way to the tool.
Place Scara::motors_of(const Place& tool) const {
  const Flat here = from_shoulder(tool);
  const std::int64_t proximal = parameters_.proximal.count();
  const std::uint64_t away = square(here.x) + square(here.y);
  const std::int64_t distance = std::max<std::int64_t>(nearest_root(away), 1);
  const auto doubled = static_cast<std::int64_t>(away + square(proximal)) -
                       static_cast<std::int64_t>(square(parameters_.distal.count()));
  const std::int64_t along =
      std::clamp(nearest_quotient(doubled, 2 * distance), -proximal, proximal);
  const std::int64_t height = nearest_root(square(proximal) - square(along));
  const std::int64_t aside = parameters_.elbow_left ? height : -height;
  const std::int64_t x = nearest_quotient(along * here.x - aside * here.y, distance);
  const std::int64_t y = nearest_quotient(along * here.y + aside * here.x, distance);
  return {in_turn_of(direction_of(x, y), parameters_.end_stop[0]),
          in_turn_of(direction_of(here.x - x, here.y - y), parameters_.end_stop[1]), tool[2],
          tool[3]};
}

Place Scara::place_of(const Place& motors) const {
  const Vector proximal = arm(parameters_.proximal, motors[0]);
  const Vector distal = arm(parameters_.distal, motors[1]);
  const auto sum = [&](Nanometers shoulder, std::size_t i) {
    return shoulder + Nanometers(std::int64_t{proximal[i]} + distal[i]);
  };
  return {sum(parameters_.shoulder_x, 0), sum(parameters_.shoulder_y, 1), motors[2], motors[3]};
}

std::uint32_t Scara::sine_at(std::uint64_t square_of_distance) const {
  const std::uint64_t sides =
      square(parameters_.proximal.count()) + square(parameters_.distal.count());
  const std::uint64_t off =
      square_of_distance < sides ? sides - square_of_distance : square_of_distance - sides;
  const Scaled cosine =
      Scaled::of(off) / (of(parameters_.proximal) * of(parameters_.distal) * Scaled::of(2));
  constexpr std::uint64_t one = std::uint64_t{1} << sine_bits;
  const std::uint64_t size = std::min(cosine.floor(sine_bits), one);
  return std::max(nearest_root(one * one - size * size), lowest_sine);
}

// The sine is a concave function of the square of the distance: it is least at an end.
std::uint32_t Scara::least_sine(const Place& from, const Place& to) const {
  const Span span = squares(from_shoulder(from), from_shoulder(to));
  return std::min(sine_at(span.least), sine_at(span.most));
}

// On the way w the arms turn by w cos A / (proximal sine) and w cos B / (distal sine), with the
// angles A of the distal and B of the proximal arm to the line. While both turn evenly, each
// moves the tool from the chord by an eighth of length * angle^2, times sin B and sin A: at most
//   w^2 / (8 sine^2 shorter arm), since cos^2 A sin B + cos^2 B sin A <= 1
std::uint32_t Scara::chords(const Place& from, const Place& to) const {
  const Scaled by_deviation =
      Scaled::of_word(horizontal_length(from, to)) /
      (Scaled::of(8 * path_deviation) * of(std::min(parameters_.proximal, parameters_.distal)))
          .square_root() /
      Scaled::of_word(least_sine(from, to), -sine_bits);
  return static_cast<std::uint32_t>(by_deviation.floor()) + 1;
}

// On a straight line an arm's acceleration is at most
//   v^2 (1 / proximal + 1 / distal) / (length sine^3) radians
// with the speed v in XY.
units::MicrometersPerSecond Scara::speed_limit(const Place& from, const Place& to,
                                               units::MicrometersPerSecondSquared most) const {
  const std::uint32_t way = horizontal_length(from, to);
  if (way == 0) return max_speed;
  // pi / 180'000 in 10^-12, and nm^2 in an um^2.
  constexpr std::uint32_t radians = 17'453'293;
  constexpr std::uint64_t fractions = 1'000'000'000'000, square_nanometers = 1'000'000;
  const Scaled sine = Scaled::of_word(least_sine(from, to), -sine_bits);
  const Scaled length = spatial_length(from, to) / Scaled::of_word(way);
  const Scaled square =
      Scaled::of(magnitude(most.count())) * Scaled::of_word(radians) / Scaled::of(fractions) *
      of(std::min(parameters_.proximal, parameters_.distal)) * of(parameters_.proximal) *
      of(parameters_.distal) / of(parameters_.proximal + parameters_.distal) * sine * sine * sine *
      length * length / Scaled::of(square_nanometers);
  const std::uint64_t speed = square.square_root().floor();
  return units::MicrometersPerSecond(
      static_cast<std::int32_t>(std::clamp<std::uint64_t>(speed, 1, magnitude(max_speed.count()))));
}

Home Scara::home() const {
  Home home;
  home.tool = {parameters_.home_x, parameters_.home_y, parameters_.height};
  const Place motors = motors_of(home.tool);
  for (const std::size_t i : {0UZ, 1UZ}) {
    home.behind_end_stop[i] = motors[i].nearest() - parameters_.end_stop[i];
  }
  return home;
}

}  // namespace motion::kinematics
