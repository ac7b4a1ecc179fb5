// SPDX-License-Identifier: Apache-2.0
// A place on an axis, or the distance between two, without rounding error.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace units {

// Whole nanometres and, above them, 0 .. 999'999 femtometres. Femtometres hold exactly what G-code
// can request: a billionth of a millimetre (1000 fm), of an inch (25'400 fm), and whole percentages
// of either, so that no sequence of relative moves drifts. Overflow is the caller's to exclude.
class Position {
 public:
  static constexpr std::int32_t femtometers_per_nanometer = 1'000'000;

  constexpr Position() = default;
  // One by one, since compilers that save space make a call of a copy of three words.
  [[gnu::always_inline]] constexpr Position(const Position& other)
      : whole_(other.whole_), femtometers_(other.femtometers_) {}
  [[gnu::always_inline]] constexpr Position& operator=(const Position& other) {
    whole_ = other.whole_;
    femtometers_ = other.femtometers_;
    return *this;
  }
  // NOLINTNEXTLINE(google-explicit-constructor): a length in nanometres is a position.
  constexpr Position(Nanometers whole) : whole_(whole) {}
  // Any 0 <= femtometers; whole nanometres among them are carried.
  constexpr Position(Nanometers whole, std::uint32_t femtometers) {
    constexpr std::uint32_t nanometer = femtometers_per_nanometer;
    whole_ = whole;
    if (femtometers >= nanometer) {
      whole_ += Nanometers(femtometers / nanometer);
      femtometers %= nanometer;
    }
    femtometers_ = static_cast<std::int32_t>(femtometers);
  }

  // Rounded down.
  constexpr Nanometers whole() const { return whole_; }
  constexpr std::int32_t femtometers() const { return femtometers_; }
  // Halves up.
  constexpr Nanometers nearest() const {
    return femtometers_ < femtometers_per_nanometer / 2 ? whole_ : whole_ + Nanometers(1);
  }

  constexpr bool operator==(const Position&) const = default;
  constexpr bool operator<(const Position& other) const {
    return whole_ < other.whole_ || (whole_ == other.whole_ && femtometers_ < other.femtometers_);
  }
  constexpr bool operator>(const Position& other) const { return other < *this; }
  constexpr bool operator<=(const Position& other) const { return !(other < *this); }
  constexpr bool operator>=(const Position& other) const { return !(*this < other); }

  constexpr Position operator+(const Position& other) const {
    return carried(whole_ + other.whole_, femtometers_ + other.femtometers_);
  }
  constexpr Position operator-(const Position& other) const {
    return carried(whole_ - other.whole_, femtometers_ - other.femtometers_);
  }
  constexpr Position operator-() const { return carried(-whole_, -femtometers_); }
  constexpr Position& operator+=(const Position& other) { return *this = *this + other; }

 private:
  // |femtometers| < 2 nm
  static constexpr Position carried(Nanometers whole, std::int32_t femtometers) {
    if (femtometers < 0) {
      femtometers += femtometers_per_nanometer;
      whole -= Nanometers(1);
    } else if (femtometers >= femtometers_per_nanometer) {
      femtometers -= femtometers_per_nanometer;
      whole += Nanometers(1);
    }
    Position position(whole);
    position.femtometers_ = femtometers;
    return position;
  }

  Nanometers whole_{};
  std::int32_t femtometers_{};
};

}  // namespace units
