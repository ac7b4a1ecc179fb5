// SPDX-License-Identifier: Apache-2.0
// The root of the 32 leading digits is within one of the nearest.
#include "motion/kinematics/square_root.hpp"

#include "motion/scaled.hpp"
#include "units/loop_bound.hpp"

namespace motion {

std::uint32_t nearest_root(std::uint64_t square) {
  std::uint64_t root = Scaled::of(square).square_root().floor();
  units::LoopBound<4> up, down;
  while (root * root + root < square) {
    up.next();
    ++root;
  }
  while (root > 0 && root * root - root >= square) {
    down.next();
    --root;
  }
  return static_cast<std::uint32_t>(root);
}

}  // namespace motion
