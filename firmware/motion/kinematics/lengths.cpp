// SPDX-License-Identifier: Apache-2.0
// By Pythagoras, between places that are rounded to the nanometre.
#include "motion/kinematics/lengths.hpp"

#include "motion/kinematics/square_root.hpp"

namespace motion::kinematics {

std::uint32_t horizontal_length(const Place& from, const Place& to) {
  return nearest_root(square((to[0] - from[0]).nearest().count()) +
                      square((to[1] - from[1]).nearest().count()));
}

Scaled spatial_length(const Place& from, const Place& to) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < spatial_axes; ++i) sum += square((to[i] - from[i]).nearest().count());
  return Scaled::of(sum).square_root();
}

}  // namespace motion::kinematics
