// SPDX-License-Identifier: Apache-2.0
// Whether a reading stands still while the heat that it should follow goes up and down.
#include "thermal/stillness.hpp"

#include <algorithm>
#include <array>

#include "units/loop_bound.hpp"

namespace thermal {
namespace {

// An expected course of less (root mean square, thousandths of a degree) shows nothing.
constexpr std::int32_t least_expected = 20;

// The least of the energies of a course, of it less half of another one, and less all of that.
std::int64_t least_energy(std::int64_t energy, std::int64_t with_other, std::int64_t of_other) {
  return std::min({energy, energy - with_other + of_other / 4, energy - 2 * with_other + of_other});
}

// The energy that a course has in common with `answer`, whose own is `expected`, and its slope.
std::int64_t energy_in_common(ConstValues course, ConstValues answer, std::int64_t expected,
                              Values slope) {
  const std::size_t last = answer.size() - 1;
  units::LoopBound<longest_course, 5> bound;
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

}  // namespace

bool Stillness::add(const Window& window) {
  append(windows_.celsius, window.celsius);
  append(windows_.answer, window.answer);
  append(windows_.given, window.given);
  append(windows_.taken, window.taken);
  append(windows_.spread, window.spread);
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

// The readings, by their difference to the first one, and what is expected of them.
void Stillness::copy_last(Values course, Values answer) const {
  const ConstValues readings = last(windows_.celsius, course.size());
  const std::int32_t* reading = readings.data();
  const std::int32_t* const end = reading + readings.size();
  const std::int32_t* expected = last(windows_.answer, answer.size()).data();
  std::int32_t* to_course = course.data();
  std::int32_t* to_answer = answer.data();
  units::LoopBound<longest_course, 8> bound;
  do {
    bound.next();
    *to_course++ = *reading++ - readings.front();
    *to_answer++ = *expected++;
  } while (reading != end);
}

bool Stillness::is_still_for_now() const {
  constexpr std::size_t length = lasting_length;
  if (seen_ < length) return false;
  std::array<std::int32_t, length> course, answer;  // set by the next call
  copy_last(course, answer);
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
  copy_last(course, answer);
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
  units::LoopBound<longest_course, 9> bound;
  for (const std::int32_t spread : last(windows_.spread, length)) {
    bound.next();
    squares += std::int64_t{spread} * spread;
  }
  return squares / (is_slow_ ? 228 : 76);
}

bool Stillness::is_still(const Limits& limits, ConstValues course, ConstValues answer,
                         const Energies& energies) const {
  const std::size_t length = limits.length;
  Course given_course, taken_course;
  const Values given = Values(given_course).first(length);
  const Values taken = Values(taken_course).first(length);
  accumulate(given, last(windows_.given, length));
  accumulate(taken, last(windows_.taken, length));
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
