// SPDX-License-Identifier: Apache-2.0
// Taylor series of an eighth of a turn, and its inversion by Newton's method.
#include "motion/rotation.hpp"

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

#include "motion/scaled.hpp"
#include "units/magnitude.hpp"

namespace motion {

namespace {

using units::magnitude;

constexpr std::uint32_t one = 1u << 31;  // the series are summed up in 2^-31
constexpr std::uint64_t unit = std::uint64_t{1} << 32;

// 1 / n in 2^-32, for the quotients of successive terms: x^2 / (2 * 3), x^2 / (4 * 5), ...
constexpr std::uint32_t inverse(std::uint32_t n) { return static_cast<std::uint32_t>(unit / n); }
constexpr std::array sine_quotients{inverse(10 * 11), inverse(8 * 9), inverse(6 * 7),
                                    inverse(4 * 5), inverse(2 * 3)};
constexpr std::array cosine_quotients{inverse(11 * 12), inverse(9 * 10), inverse(7 * 8),
                                      inverse(5 * 6),   inverse(3 * 4),  inverse(1 * 2)};

// 1 - x^2 q (1 - x^2 q' (...)), the last quotient being the outermost; by Horner's rule.
template <std::size_t terms>
std::uint32_t alternating_series(std::uint32_t square,
                                 const std::array<std::uint32_t, terms>& quotients) {
  std::uint32_t sum = one;
  for (const std::uint32_t quotient : quotients) {
    const auto product = static_cast<std::uint32_t>(std::uint64_t{square} * sum >> 31);
    sum = one - static_cast<std::uint32_t>(std::uint64_t{product} * quotient >> 32);
  }
  return sum;
}

// By quarters of a turn, counter-clockwise.
template <class Number>
std::pair<Number, Number> turned_by_quarters(Number x, Number y, std::uint32_t quarters) {
  switch (quarters % 4) {
    case 1:
      return {-y, x};
    case 2:
      return {-x, -y};
    case 3:
      return {y, -x};
    default:
      return {x, y};
  }
}

// y / x in 2^-31, for |y| <= x.
std::int64_t slope(std::int64_t x, std::int64_t y) {
  const Scaled ratio = Scaled::of(magnitude(y)) / Scaled::of(magnitude(x));
  const auto size = static_cast<std::int64_t>(ratio.floor(31));
  return y < 0 ? -size : size;
}

}  // namespace

Rotation rotation_by(Angle angle) {
  constexpr std::int64_t pi = 1'686'629'713;  // in 2^-29
  const Angle quarters = (angle + (1u << 29)) >> 30;
  const auto rest = static_cast<std::int32_t>(angle - (quarters << 30));  // an eighth at most
  const std::int64_t radians = rest * pi >> 29;  // in 2^-31
  const auto square = static_cast<std::uint32_t>(radians * radians >> 31);
  const std::int64_t sine = radians * alternating_series(square, sine_quotients) >> 31;
  const std::int64_t cosine = alternating_series(square, cosine_quotients);
  const auto [x, y] = turned_by_quarters((cosine + 1) >> 1, (sine + 1) >> 1, quarters);
  return {.cosine = static_cast<std::int32_t>(x), .sine = static_cast<std::int32_t>(y)};
}

Vector turned(const Vector& vector, Angle by) {
  const Rotation rotation = rotation_by(by);
  const auto rounded = [](std::int64_t product) {
    return static_cast<std::int32_t>((product + (1 << 29)) >> 30);
  };
  const std::int64_t x = vector[0], y = vector[1];
  return {rounded(x * rotation.cosine - y * rotation.sine),
          rounded(x * rotation.sine + y * rotation.cosine)};
}

Angle angle_between(const Vector& from, const Vector& to) {
  // As complex numbers: to times the conjugate of from.
  std::int64_t x = std::int64_t{from[0]} * to[0] + std::int64_t{from[1]} * to[1];
  std::int64_t y = std::int64_t{from[0]} * to[1] - std::int64_t{from[1]} * to[0];
  const std::uint64_t largest = std::max(magnitude(x), magnitude(y));
  if (largest == 0) return 0;
  const int surplus = static_cast<int>(std::bit_width(largest)) - 30;
  x = surplus > 0 ? x >> surplus : x * (std::int64_t{1} << -surplus);
  y = surplus > 0 ? y >> surplus : y * (std::int64_t{1} << -surplus);

  const std::uint32_t quarters = magnitude(y) <= magnitude(x) ? (x < 0 ? 2 : 0) : (y > 0 ? 1 : 3);
  std::tie(x, y) = turned_by_quarters(x, y, 4 - quarters);
  // Now |y| <= x. A straight line through 0 and an eighth of a turn is 0.07 radians off at most;
  // the tangent of what is left is it, but for a third of its cube.
  constexpr std::int64_t angle_of_radian = 683'565'276;  // 2^32 / (2 pi)
  auto angle = static_cast<Angle>(slope(x, y) >> 2);
  for (int i = 0; i < 2; ++i) {
    const Rotation back = rotation_by(Angle{0} - angle);
    const std::int64_t rest_x = (x * back.cosine - y * back.sine) >> 30;
    const std::int64_t rest_y = (x * back.sine + y * back.cosine) >> 30;
    angle += static_cast<Angle>(slope(rest_x, rest_y) * angle_of_radian >> 31);
  }
  return angle + (quarters << 30);
}

}  // namespace motion
