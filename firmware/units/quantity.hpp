// SPDX-License-Identifier: Apache-2.0
// Quantities as types: an integer that knows its unit, so that a length is never added to a speed.
#pragma once

#include <cstdint>

namespace units {

// A count of one unit. Sums, differences and comparisons stay within the unit; scaling is by plain
// integers; everything else (length by time, conversion between units) is written out by a named
// function, where its rounding and its range can be seen. Overflow is the caller's to exclude.
template <class Unit, class Integer>
class Quantity {
 public:
  using Representation = Integer;

  constexpr Quantity() = default;
  explicit constexpr Quantity(Integer count) : count_(count) {}

  constexpr Integer count() const { return count_; }

  constexpr bool operator==(const Quantity&) const = default;
  // One by one, since compilers make a call of `<=>` where an instruction does.
  constexpr bool operator<(Quantity other) const { return count_ < other.count_; }
  constexpr bool operator>(Quantity other) const { return count_ > other.count_; }
  constexpr bool operator<=(Quantity other) const { return count_ <= other.count_; }
  constexpr bool operator>=(Quantity other) const { return count_ >= other.count_; }
  constexpr Quantity operator-() const { return Quantity(static_cast<Integer>(-count_)); }
  constexpr Quantity operator+(Quantity other) const { return Quantity(count_ + other.count_); }
  constexpr Quantity operator-(Quantity other) const { return Quantity(count_ - other.count_); }
  constexpr Quantity operator*(Integer factor) const { return Quantity(count_ * factor); }
  constexpr Quantity operator/(Integer divisor) const { return Quantity(count_ / divisor); }
  constexpr Quantity& operator+=(Quantity other) { return *this = *this + other; }
  constexpr Quantity& operator-=(Quantity other) { return *this = *this - other; }

 private:
  Integer count_{};
};

using Nanometers = Quantity<struct NanometerUnit, std::int64_t>;
using MicrometersPerSecond = Quantity<struct MicrometerPerSecondUnit, std::int32_t>;
using MicrometersPerSecondSquared = Quantity<struct MicrometerPerSecondSquaredUnit, std::int32_t>;
using StepsPerMeter = Quantity<struct StepPerMeterUnit, std::int32_t>;
using Steps = Quantity<struct StepUnit, std::int32_t>;
using Millicelsius = Quantity<struct MillicelsiusUnit, std::int32_t>;
using Milliohms = Quantity<struct MilliohmUnit, std::int64_t>;
using Microseconds = Quantity<struct MicrosecondUnit, std::int64_t>;
using Milliseconds = Quantity<struct MillisecondUnit, std::int64_t>;
using Cycles = Quantity<struct CycleUnit, std::int64_t>;
using Hertz = Quantity<struct HertzUnit, std::uint32_t>;

}  // namespace units
