// SPDX-License-Identifier: Apache-2.0
// Angles as parts of a turn, and what turns a vector by one, in integers.
#pragma once

#include <array>
#include <cstdint>

namespace motion {

// 2^-32 of a turn each, so that a whole turn is 0 again; counter-clockwise.
using Angle = std::uint32_t;

// Cosine and sine in 2^-30, to within 2^-30.
struct Rotation {
  std::int32_t cosine{};
  std::int32_t sine{};
};

Rotation rotation_by(Angle angle);

// Components of up to 30 bits and a sign.
using Vector = std::array<std::int32_t, 2>;

Vector turned(const Vector& vector, Angle by);

// From the direction of one vector to that of the other, to within 2^-27 radians; 0 if one is 0.
Angle angle_between(const Vector& from, const Vector& to);

}  // namespace motion
