// SPDX-License-Identifier: Apache-2.0
// Arithmetic of courses: values by window, the newest at the end, in thousandths of a degree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace thermal {

inline constexpr std::size_t longest_course = 54;

// At least two values, at most `longest_course`.
using Values = std::span<std::int32_t>;
using ConstValues = std::span<const std::int32_t>;

// The oldest value leaves.
void append(Values values, std::int32_t newest);
// The mean with both neighbours, which takes noise and leaves a slow rhythm.
void smooth(Values values);
// Within 4 degrees of the mean: no sum exceeds 31 bits.
void subtract_mean(Values values);
// Less mean and slope, by least squares.
void subtract_line(Values values);
// The course of a temperature that gains so much in each window, from the middle of each to the
// middle of the next, less its line.
void accumulate(Values course, ConstValues gains);

// Of courses from their means, or less their lines too, which makes an energy smaller.
std::int64_t product(ConstValues one, ConstValues other);
inline std::int64_t energy(ConstValues values) { return product(values, values); }

}  // namespace thermal
