// SPDX-License-Identifier: Apache-2.0
// Circular moves, G2 and G3, as chords: straight moves whose ends lie on the circle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>

#include "motion/fault.hpp"
#include "motion/limits.hpp"
#include "motion/rotation.hpp"
#include "motion/share.hpp"
#include "units/axes.hpp"
#include "units/position.hpp"
#include "units/quantity.hpp"

namespace motion {

// How far a chord's middle lies off the circle, at most: less than half a step of a usual machine,
// so that the steps are rarely others than those of the circle. Marlin's chords of 1 mm are off by
// 0.125 mm at a radius of 1 mm.
inline constexpr units::Nanometers chord_deviation{5'000};
// What ArcWelder writes at most, and what the integers here hold.
inline constexpr units::Nanometers largest_radius{10'000'000'000};

// G17, G18, G19. The first axis turns into the second one counter-clockwise.
enum class Plane : std::uint8_t { xy, zx, yz };

constexpr std::array<units::Axis, 2> axes_of(Plane plane) {
  using units::Axis;
  switch (plane) {
    case Plane::zx:
      return {Axis::z, Axis::x};
    case Plane::yz:
      return {Axis::y, Axis::z};
    case Plane::xy:
      break;
  }
  return {Axis::x, Axis::y};
}

// On the first and the second axis of a plane.
using PlaneVector = std::array<units::Nanometers, 2>;

struct ArcRequest {
  Plane plane{};
  bool clockwise{};
  units::PerAxis<units::Position> start{}, target{};
  PlaneVector centre{};  // from the start
};

// Puts the centre where start and target are so far from it: for less than half a circle with a
// positive radius, for more with a negative one.
std::expected<void, Fault> set_centre(ArcRequest& request, units::Nanometers radius);

// The two other axes of XYZE go evenly from start to target. Where the target does not lie on the
// circle through the start, by as much as decimals of slicers are rounded, the difference is spread
// evenly over the arc. An arc that ends where it begins is a full circle.
class Arc {
 public:
  // After a fault there is no arc.
  std::expected<void, Fault> begin(const ArcRequest& request);

  // Of next().
  bool begun() const { return made_ != 0; }
  bool done() const { return made_ == chords_; }
  const units::PerAxis<units::Position>& target() const { return request_.target; }
  std::uint32_t chords() const { return chords_; }
  // The end of the next chord; of the last one exactly the target. Not if done().
  units::PerAxis<units::Position> next();

  // Between these lie all chords in the plane; on the other axes both are the target. They are the
  // ends and the outermost points of the circle, less 100 nm, so that one that touches the end of a
  // travel is not beyond it by rounding.
  units::PerAxis<units::Position> lowest() const { return with_extremes(&Range::low); }
  units::PerAxis<units::Position> highest() const { return with_extremes(&Range::high); }
  // The speed at which the acceleration towards the centre is no more than this one, nor than the
  // plane's axes are allowed.
  units::MicrometersPerSecond speed_limit(const Limits& limits,
                                          units::MicrometersPerSecondSquared acceleration) const;

 private:
  struct Range {
    units::Nanometers low, high;
  };

  units::PerAxis<units::Position> with_extremes(units::Nanometers Range::* side) const;
  void set_extremes(std::uint64_t sweep);
  void divide(std::uint64_t sweep, const Vector& at_end);
  units::Nanometers centre_on(std::size_t side) const;

  ArcRequest request_{};
  std::array<units::Axis, 2> axes_{};  // of the plane
  Vector from_centre_{};  // to the start, in 2^4 nm, as all vectors here
  std::uint32_t radius_{};  // 2^4 nm, the larger one of those at start and target
  std::array<Range, 2> ranges_{};  // of the plane's axes
  std::uint32_t chords_{}, made_{};
  std::uint64_t angle_{}, angle_step_{};  // 2^-64 of a turn
  units::PerAxis<Share> shares_{};  // what is covered evenly, nm
};

}  // namespace motion
