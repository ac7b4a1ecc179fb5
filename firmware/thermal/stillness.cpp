// SPDX-License-Identifier: Apache-2.0
// Whether a reading stands still while the heat that it should follow goes up and down.
#include "thermal/stillness.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "units/loop_bound.hpp"

namespace thermal {
namespace {

// Of a course from its mean, in thousandths of a degree, so that no sum exceeds 31 bits.
constexpr std::int32_t farthest = 4'000;
// An expected course of less (root mean square, thousandths of a degree) shows nothing.
constexpr std::int32_t least_expected = 20;

using Values = std::span<std::int32_t>;
using ConstValues = Stillness::ConstValues;

// Of loops over the values of a course.
template <std::uint32_t tag>
using CourseBound = units::LoopBound<Stillness::longest, tag>;

// Rounded to zero, for sums of three that are up to 2^31: a division takes the processor 18 clocks.
constexpr std::int32_t third(std::int32_t sum) {
  constexpr std::int64_t reciprocal = 0x5555'5556;  // of 3, with 32 fractional bits
  return static_cast<std::int32_t>(sum * reciprocal >> 32) + (sum < 0 ? 1 : 0);
}
static_assert(third(8) == 2 && third(9) == 3 && third(-8) == -2 && third(-9) == -3);
static_assert(third(std::numeric_limits<std::int32_t>::max()) == 715'827'882);
static_assert(third(std::numeric_limits<std::int32_t>::min()) == -715'827'882);

// The mean with both neighbours, which takes noise and leaves a slow rhythm.
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
  std::int32_t sum = 0;
  CourseBound<1> summed;
  for (const std::int32_t value : values) {
    summed.next();
    sum += value;
  }
  const std::int32_t mean = sum / static_cast<std::int32_t>(values.size());
  CourseBound<2> changed;
  for (std::int32_t& value : values) {
    changed.next();
    value = std::clamp(value - mean, -farthest, farthest);
  }
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
  units::LoopBound<Stillness::longest / 2> bound;
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

// Less mean and slope, by least squares.
void subtract_line(Values values) {
  subtract_mean(values);
  const auto count = static_cast<std::int32_t>(values.size());
  const std::int32_t squares = count * (count * count - 1) / 3;  // of `place` below
  std::int32_t sum = 0, place = 1 - count;
  CourseBound<3> bound;
  for (const std::int32_t value : values) {
    bound.next();
    sum += value * place;
    place += 2;
  }
  subtract_slope(values, sum / 16, squares / 16);
}

// Of courses from their means, or less their lines too, which makes an energy smaller: 31 bits hold
// the energy of one that is `farthest` throughout, and so each product.
static_assert(std::int64_t{farthest} * farthest * Stillness::longest <
              std::numeric_limits<std::int32_t>::max() / 2);
std::int64_t product(ConstValues one, ConstValues other) {
  std::int32_t sum = 0;
  CourseBound<4> bound;
  for (std::size_t i = 0; i < one.size(); ++i) {
    bound.next();
    sum += one[i] * other[i];
  }
  return sum;
}
std::int64_t energy(ConstValues values) { return product(values, values); }

// The least of the energies of a course, of it less half of another one, and less all of that.
std::int64_t least_energy(std::int64_t energy, std::int64_t with_other, std::int64_t of_other) {
  return std::min({energy, energy - with_other + of_other / 4, energy - 2 * with_other + of_other});
}

// The energy that a course has in common with `answer`, whose own is `expected`, and its slope.
std::int64_t energy_in_common(ConstValues course, ConstValues answer, std::int64_t expected,
                              Values slope) {
  const std::size_t last = answer.size() - 1;
  CourseBound<5> bound;
  for (std::size_t i = 0; i <= last; ++i) {
    bound.next();
    slope[i] = answer[std::min(i + 1, last)] - answer[i == 0 ? 0 : i - 1];
  }
  subtract_line(slope);
  const std::int64_t course_answer = product(course, answer);
  const std::int64_t slope_answer = product(slope, answer);
  std::int64_t common = course_answer * course_answer / expected;
  // What of the slope is no part of the answer.
  const std::int64_t slopes = energy(slope);
  const std::int64_t rest = slopes - slope_answer * slope_answer / expected;
  if (rest > slopes / 1'000) {
    const std::int64_t course_rest =
        product(course, slope) - course_answer * slope_answer / expected;
    common += course_rest * course_rest / rest;
  }
  return common;
}

// Whether `part` is at most so many percent of `whole`, as amplitudes.
bool is_within(std::int64_t part, std::int64_t whole, std::int32_t percent) {
  return part * 10'000 < whole * percent * percent;
}

// The course of a temperature that gets so much in each window, from the middle of each to the
// middle of the next.
template <class Gain>
void accumulate(Values course, Gain gain) {
  std::int32_t mean = 0;
  CourseBound<6> summed;
  for (std::size_t i = 0; i < course.size(); ++i) {
    summed.next();
    mean += gain(i);
  }
  mean /= static_cast<std::int32_t>(course.size());
  std::int32_t before = gain(0), sum = 0;
  course[0] = 0;
  CourseBound<7> changed;
  for (std::size_t i = 1; i < course.size(); ++i) {
    changed.next();
    const std::int32_t now = gain(i);
    sum += (before + now) / 2 - mean;
    course[i] = sum;
    before = now;
  }
  subtract_line(course);
}

}  // namespace

bool Stillness::add(const Window& window) {
  std::shift_left(windows_.begin(), windows_.end(), 1);
  windows_.back() = window;
  seen_ = std::min(seen_ + 1, longest);
  undisturbed_ = std::min(undisturbed_ + 1, longest);
  still_ = is_still_for_now() ? std::min(still_ + 1, lasting_length) : 0;
  unjudged_ = limits().size();
  return still_ >= lasting_length;
}

bool Stillness::look_further() {
  if (unjudged_ == 0) return false;
  --unjudged_;
  judged_ = judged_ + 1 < limits().size() ? judged_ + 1 : 0;
  return is_still(limits()[judged_]);
}

bool Stillness::is_still_for_now() const {
  constexpr std::size_t length = lasting_length;
  if (seen_ < length) return false;
  std::array<std::int32_t, length> course{}, answer{};
  for (std::size_t i = 0; i < length; ++i) {
    course[i] = window(length, i).celsius - window(length, 0).celsius;
    answer[i] = window(length, i).answer;
  }
  subtract_mean(course);
  subtract_line(answer);
  const std::int64_t expected = energy(answer);
  return expected >= std::int64_t{length} * least_expected * least_expected &&
         is_within(energy(course), expected, lasting_limit);
}

bool Stillness::is_still(const Limits& limits) const {
  const std::size_t length = limits.length;
  if (seen_ < length || undisturbed_ < length) return false;
  Course courses, answers;  // set below as far as they are used
  const Values course = Values(courses).first(length), answer = Values(answers).first(length);
  CourseBound<8> bound;
  for (std::size_t i = 0; i < length; ++i) {
    bound.next();
    course[i] = window(length, i).celsius - window(length, 0).celsius;
    answer[i] = window(length, i).answer;
  }
  if (is_slow_) smooth(course);
  if (is_slow_) smooth(answer);
  subtract_mean(course);
  subtract_line(answer);
  // Mostly it lives, and that is all.
  const Energies energies{.course = energy(course), .answer = energy(answer)};
  if (!is_within(energies.course, energies.answer, limits.with_rhythm + limits.rest)) return false;
  return is_still(limits, course, answer, energies);
}

// Of ten conversions the mean without the outermost two has a variance of 1/76 of their spread's
// square; smoothed, a third of it.
std::int64_t Stillness::noise(std::size_t length) const {
  std::int64_t squares = 0;
  CourseBound<9> bound;
  for (std::size_t i = 0; i < length; ++i) {
    bound.next();
    const std::int64_t spread = window(length, i).spread;
    squares += spread * spread;
  }
  return squares / (is_slow_ ? 228 : 76);
}

bool Stillness::is_still(const Limits& limits, ConstValues course, ConstValues answer,
                         const Energies& energies) const {
  const std::size_t length = limits.length;
  Course given_course, taken_course;
  const Values given = Values(given_course).first(length);
  const Values taken = Values(taken_course).first(length);
  accumulate(given, [this, length](std::size_t i) { return window(length, i).given; });
  accumulate(taken, [this, length](std::size_t i) { return window(length, i).taken; });
  const std::int64_t lost = energy(taken);
  if (lost > energies.answer) return false;
  const std::int64_t expected =
      std::min(least_energy(energies.answer, product(answer, taken), lost),
               least_energy(energy(given), product(given, taken), lost));
  if (expected < static_cast<std::int64_t>(length) * least_expected * least_expected) return false;
  const std::int64_t noisy = noise(length);
  // A reading whose noise alone exceeds what the rest may be is within it by chance only: it is
  // judged over a longer time.
  if (!is_within(noisy * 9 / 20, expected, limits.rest)) return false;
  // Two of `length` dimensions of the noise go with the rhythm. Of the others, which are estimated
  // from few conversions, two thirds are taken off.
  const std::int64_t common = energy_in_common(course, answer, energies.answer, given);
  const std::int64_t with_rhythm = common - 2 * noisy / static_cast<std::int64_t>(length);
  const std::int64_t rest = energies.course - common - noisy * 2 / 3;
  return is_within(with_rhythm, expected, limits.with_rhythm) &&
         is_within(rest, expected, limits.rest);
}

}  // namespace thermal
