// SPDX-License-Identifier: Apache-2.0
// The geometry of arcs in integers.
#include "motion/arc.hpp"

#include <algorithm>
#include <bit>

#include "motion/scaled.hpp"
#include "units/magnitude.hpp"

namespace motion {

namespace {

using units::index_of;
using units::magnitude;
using units::Nanometers;

// Vectors in the plane are in 2^4 nm: then 32 bits hold the largest radius, and chords end within
// a thousandth of a usual step.
constexpr int unit_bits = 4;
constexpr std::uint32_t units_of(Nanometers length) {
  return static_cast<std::uint32_t>(length.count() >> unit_bits);
}
constexpr std::uint64_t whole_turn = std::uint64_t{1} << 32;
// By how much the radius may differ at start and target, if a thousandth of it is not between them.
constexpr std::uint32_t least_mismatch = units_of(Nanometers(20'000));
constexpr std::uint32_t most_mismatch = units_of(Nanometers(500'000));
constexpr Nanometers rounding{100};

std::uint32_t allowed_mismatch(std::uint32_t radius) {
  return std::clamp(radius / 1000, least_mismatch, most_mismatch);
}

// False beyond the largest diameter.
bool narrow(const PlaneVector& vector, Vector& narrowed) {
  for (std::size_t side = 0; side < 2; ++side) {
    if (magnitude(vector[side].count()) > magnitude(2 * largest_radius.count())) return false;
    narrowed[side] = static_cast<std::int32_t>(vector[side].count() >> unit_bits);
  }
  return true;
}

Scaled length_of(const Vector& vector) {
  const std::int64_t x = vector[0], y = vector[1];
  return Scaled::of(static_cast<std::uint64_t>(x * x + y * y)).square_root();
}

std::uint32_t radius_of(const Vector& vector) {
  return static_cast<std::uint32_t>(length_of(vector).floor());
}

PlaneVector way_of(const ArcRequest& request) {
  PlaneVector way;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t axis = index_of(axes_of(request.plane)[side]);
    way[side] = (request.target[axis] - request.start[axis]).nearest();
  }
  return way;
}

}  // namespace

// In nanometres as long as 31 bits hold the way and the diameter, and the squares are exact: near
// half a circle the centre depends on the last digit.
std::expected<void, Fault> set_centre(ArcRequest& request, Nanometers radius) {
  const bool large_part = radius < Nanometers();
  const PlaneVector way = way_of(request);
  const std::uint64_t size = magnitude(radius.count());
  const std::uint64_t x = magnitude(way[0].count()), y = magnitude(way[1].count());
  if (size > magnitude(largest_radius.count()) ||
      std::max(x, y) > 2 * magnitude(largest_radius.count())) {
    return std::unexpected(Fault::arc_too_large);
  }
  const int surplus = std::max(0, static_cast<int>(std::bit_width(x | y | 2 * size)) - 31);
  const std::uint64_t diameter = 2 * size >> surplus;
  const std::uint64_t square = (x >> surplus) * (x >> surplus) + (y >> surplus) * (y >> surplus);
  if (square == 0 || size == 0) return std::unexpected(Fault::arc_without_radius);
  const Scaled length = Scaled::of(square).square_root();
  const std::uint64_t half = length.half().floor(surplus - unit_bits);
  const std::uint32_t limit = units_of(Nanometers(static_cast<std::int64_t>(size)));
  if (half > limit + allowed_mismatch(limit)) return std::unexpected(Fault::arc_ends_too_far_apart);
  // From the middle between the ends to the left of the way for the small part counter-clockwise.
  Scaled height;  // by the length
  if (diameter * diameter > square) {
    height = Scaled::of(diameter * diameter - square).square_root().half() / length;
  }
  const bool left = request.clockwise == large_part;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::int64_t across = way[1 - side].count();
    const Scaled offset_size = Scaled::of(magnitude(across) >> surplus) * height;
    const auto offset = static_cast<std::int64_t>(offset_size.floor(surplus));
    const bool positive = (across < 0) == (left == (side == 0));
    request.centre[side] = Nanometers(way[side].count() / 2 + (positive ? offset : -offset));
  }
  return {};
}

std::expected<void, Fault> Arc::begin(const ArcRequest& request) {
  chords_ = made_ = 0;
  request_ = request;
  axes_ = axes_of(request.plane);
  const PlaneVector way = way_of(request);
  PlaneVector to_start, to_end;
  for (std::size_t side = 0; side < 2; ++side) {
    to_start[side] = -request.centre[side];
    to_end[side] = to_start[side] + way[side];
  }
  Vector at_end;
  if (!narrow(to_start, from_centre_)) return std::unexpected(Fault::arc_too_large);
  if (!narrow(to_end, at_end)) return std::unexpected(Fault::arc_end_off_circle);
  const std::uint32_t start_radius = radius_of(from_centre_), end_radius = radius_of(at_end);
  if (start_radius == 0) return std::unexpected(Fault::arc_without_radius);
  if (start_radius > units_of(largest_radius)) return std::unexpected(Fault::arc_too_large);
  radius_ = std::max(start_radius, end_radius);
  if (radius_ - std::min(start_radius, end_radius) > allowed_mismatch(start_radius)) {
    return std::unexpected(Fault::arc_end_off_circle);
  }
  const Angle angle = angle_between(from_centre_, at_end);
  const bool closed = angle == 0 || (way[0] == Nanometers() && way[1] == Nanometers());
  divide(closed              ? whole_turn
         : request.clockwise ? whole_turn - angle
                             : std::uint64_t{angle},
         at_end);
  return {};
}

// The middle of a chord over the angle t lies r (1 - cos(t / 2)) < r t^2 / 8 within the circle, so
// that t = sqrt(8 deviation / r); a radian at most, since the smallest circles are none otherwise.
void Arc::divide(std::uint64_t sweep, const Vector& at_end) {
  constexpr std::uint64_t turn_in_radians = 26'986'075'409;  // 2 pi, in 2^-32
  const Scaled radians = Scaled::of(sweep, -32) * Scaled::of(turn_in_radians, -32);
  const Scaled per_radian =
      (Scaled::of(radius_) / Scaled::of(units_of(chord_deviation * 8))).square_root();
  const Scaled chords = radians * std::max(per_radian, Scaled::of(1));
  chords_ = static_cast<std::uint32_t>(chords.floor()) + 1;

  angle_ = 0;
  angle_step_ = Share(static_cast<std::int64_t>(sweep), chords_).step();
  auto end = static_cast<Angle>(sweep);
  set_extremes(sweep);
  if (request_.clockwise) {
    angle_step_ = 0 - angle_step_;
    end = 0 - end;
  }
  const Vector turned = motion::turned(from_centre_, end);
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    shares_[i] = Share((request_.target[i] - request_.start[i]).nearest().count(), chords_);
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const std::int64_t missing = std::int64_t{at_end[side]} - turned[side];
    shares_[index_of(axes_[side])] = Share(missing << unit_bits, chords_);
  }
}

units::PerAxis<units::Position> Arc::next() {
  ++made_;
  if (done()) return request_.target;
  angle_ += angle_step_;
  units::PerAxis<units::Position> end;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    shares_[i].advance();
    end[i] = request_.start[i].whole() + Nanometers(shares_[i].covered());
  }
  const Vector turned = motion::turned(from_centre_, static_cast<Angle>(angle_ >> 32));
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t axis = index_of(axes_[side]);
    const Nanometers place = centre_on(side) + Nanometers(shares_[axis].covered()) +
                             Nanometers(std::int64_t{turned[side]} << unit_bits);
    end[axis] = std::clamp(place, ranges_[side].low, ranges_[side].high);
  }
  return end;
}

Nanometers Arc::centre_on(std::size_t side) const {
  return request_.start[index_of(axes_[side])].whole() + request_.centre[side];
}

// Where the arc passes a quarter of the circle it reaches out as far as it can.
void Arc::set_extremes(std::uint64_t sweep) {
  const Nanometers reach = Nanometers(std::int64_t{radius_} << unit_bits) - rounding;
  const Angle start = angle_between({1, 0}, from_centre_);
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t axis = index_of(axes_[side]);
    const Nanometers from = request_.start[axis].whole(), to = request_.target[axis].whole();
    Range& range = ranges_[side];
    range = {std::min(from, to), std::max(from, to)};
    const auto passes = [&](Angle quarter) {
      const Angle way = (quarter << 30) - start;
      return (request_.clockwise ? Angle{0} - way : way) < sweep;
    };
    const auto quarter = static_cast<Angle>(side);
    if (passes(quarter)) range.high = std::max(range.high, centre_on(side) + reach);
    if (passes(quarter + 2)) range.low = std::min(range.low, centre_on(side) - reach);
  }
}

units::PerAxis<units::Position> Arc::with_extremes(Nanometers Range::* side_of_range) const {
  units::PerAxis<units::Position> place = request_.target;
  for (std::size_t side = 0; side < 2; ++side) {
    place[index_of(axes_[side])] = ranges_[side].*side_of_range;
  }
  return place;
}

// v^2 / r
units::MicrometersPerSecond Arc::speed_limit(
    const Limits& limits, units::MicrometersPerSecondSquared acceleration) const {
  for (const units::Axis axis : axes_) {
    acceleration = std::min(acceleration, limits.of(axis).max_acceleration);
  }
  const auto size = static_cast<std::uint32_t>(acceleration.count());
  const Scaled square = Scaled::of(std::uint64_t{size} * radius_, unit_bits) / Scaled::of(1'000);
  const auto most = static_cast<std::uint64_t>(max_speed.count());
  return units::MicrometersPerSecond(
      static_cast<std::int32_t>(std::clamp<std::uint64_t>(square.square_root().floor(), 1, most)));
}

}  // namespace motion
