// SPDX-License-Identifier: Apache-2.0
// Exponential and logarithm for tables that the compiler makes; they never run on the chip.
#pragma once

namespace thermal {

// Relative error below 1e-14 for |x| < 100: Taylor series of x / 2^10, squared ten times.
consteval double exponential(double x) {
  constexpr int halvings = 10;
  const double reduced = x / (1 << halvings);
  double term = 1.0;
  double sum = 0.0;
  for (int n = 1; n < 20; ++n) {
    term *= reduced / n;
    sum += term;
  }
  // Squaring 1 + s as (1 + s)^2 - 1 = s (2 + s) keeps the digits of a small s.
  for (int i = 0; i < halvings; ++i) sum *= 2.0 + sum;
  return 1.0 + sum;
}

// Of x > 0, by Newton's method on the exponential.
consteval double logarithm(double x) {
  double result = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double power = exponential(result);
    const double correction = 2.0 * (x - power) / (x + power);
    result += correction;
    if (correction < 1e-15 && correction > -1e-15) break;
  }
  return result;
}

}  // namespace thermal
