// SPDX-License-Identifier: Apache-2.0
#include "thermal/course.hpp"

#include <algorithm>
#include <limits>

#include "units/loop_bound.hpp"

namespace thermal {
namespace {

// From the mean, so that no sum exceeds 31 bits.
constexpr std::int32_t farthest = 4'000;

// Of loops over the values of a course: it has some, so they test at their end, which takes the
// processor three clocks less for each.
template <std::uint32_t tag>
using CourseBound = units::LoopBound<longest_course, tag>;

// Rounded to zero, for sums of three that are up to 2^31: a division takes the processor 18 clocks.
constexpr std::int32_t third(std::int32_t sum) {
  constexpr std::int64_t reciprocal = 0x5555'5556;  // of 3, with 32 fractional bits
  return static_cast<std::int32_t>(sum * reciprocal >> 32) + (sum < 0 ? 1 : 0);
}
static_assert(third(8) == 2 && third(9) == 3 && third(-8) == -2 && third(-9) == -3);
static_assert(third(std::numeric_limits<std::int32_t>::max()) == 715'827'882);
static_assert(third(std::numeric_limits<std::int32_t>::min()) == -715'827'882);

std::int32_t mean_of(ConstValues values) {
  const std::int32_t* value = values.data();
  const std::int32_t* const end = value + values.size();
  std::int32_t sum = 0;
  CourseBound<1> bound;
  do {
    bound.next();
    sum += *value++;
  } while (value != end);
  return sum / static_cast<std::int32_t>(values.size());
}

// value -= factor * place / divisor, rounded to zero, at the places -(count - 1) to count - 1 in
// steps of 2. A division takes the processor 18 clocks: so quotient and remainder are carried from
// one place to the next, on both sides of the middle.
void subtract_slope(Values values, std::int32_t factor, std::int32_t divisor) {
  const std::int32_t sign = factor < 0 ? -1 : 1, magnitude = factor * sign;
  const std::int32_t step = 2 * magnitude / divisor, step_remainder = 2 * magnitude % divisor;
  std::size_t above = (values.size() + 1) / 2, below = values.size() / 2;
  const std::int32_t nearest = values.size() % 2 == 0 ? 1 : 2;
  std::int32_t quotient = magnitude * nearest / divisor;
  std::int32_t remainder = magnitude * nearest % divisor;
  units::LoopBound<longest_course / 2> bound;
  while (below > 0) {
    bound.next();
    values[above++] -= sign * quotient;
    values[--below] += sign * quotient;
    quotient += step;
    remainder += step_remainder;
    if (remainder >= divisor) {
      remainder -= divisor;
      ++quotient;
    }
  }
}

}  // namespace

void append(Values values, std::int32_t newest) {
  std::int32_t* value = values.data();
  std::int32_t* const last = value + values.size() - 1;
  CourseBound<7> bound;
  do {
    bound.next();
    *value = value[1];
  } while (++value != last);
  *last = newest;
}

void smooth(Values values) {
  std::int32_t before = values.front();
  CourseBound<0> bound;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    bound.next();
    const std::int32_t now = values[i];
    values[i] = third(before + now + values[i + 1]);
    before = now;
  }
  values.back() = third(before + 2 * values.back());
}

void subtract_mean(Values values) {
  const std::int32_t mean = mean_of(values);
  std::int32_t* value = values.data();
  std::int32_t* const end = value + values.size();
  CourseBound<2> changed;
  do {
    changed.next();
    *value = std::clamp(*value - mean, -farthest, farthest);
  } while (++value != end);
}

void subtract_line(Values values) {
  subtract_mean(values);
  const auto count = static_cast<std::int32_t>(values.size());
  const std::int32_t squares = count * (count * count - 1) / 3;  // of `place` below
  std::int32_t sum = 0, place = 1 - count;
  CourseBound<3> bound;
  const std::int32_t* value = values.data();
  do {
    bound.next();
    sum += *value++ * place;
    place += 2;
  } while (place <= count);
  subtract_slope(values, sum / 16, squares / 16);
}

// Of courses from their means, or less their lines too, which makes an energy smaller: 31 bits hold
// the energy of one that is `farthest` throughout, and so each product.
static_assert(std::int64_t{farthest} * farthest * longest_course <
              std::numeric_limits<std::int32_t>::max() / 2);
std::int64_t product(ConstValues one, ConstValues other) {
  const std::int32_t* factor = one.data();
  const std::int32_t* const end = factor + one.size();
  const std::int32_t* other_factor = other.data();
  std::int32_t sum = 0;
  CourseBound<4> bound;
  do {
    bound.next();
    sum += *factor++ * *other_factor++;
  } while (factor != end);
  return sum;
}

void accumulate(Values course, ConstValues gains) {
  const std::int32_t mean = mean_of(gains);
  const std::int32_t* gain = gains.data();
  const std::int32_t* const end = gain + gains.size();
  std::int32_t* value = course.data();
  std::int32_t before = *gain++, sum = 0;
  *value++ = 0;
  CourseBound<6> bound;
  do {
    bound.next();
    const std::int32_t now = *gain++;
    sum += (before + now) / 2 - mean;
    *value++ = sum;
    before = now;
  } while (gain != end);
  subtract_line(course);
}

}  // namespace thermal
