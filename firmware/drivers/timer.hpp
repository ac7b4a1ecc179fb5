// SPDX-License-Identifier: Apache-2.0
// The machine timer: the time in clocks, and an interrupt at a deadline.
#pragma once

#include <cstdint>

#include "units/quantity.hpp"

namespace drivers {

class Timer {
 public:
  // Clocks since reset. Two calls must not interleave (one of them in an interrupt): the second
  // half of one read would belong to the other.
  units::Cycles now() const;
  // The lower half of that, in one access: for differences.
  std::uint32_t now_low() const;

  // The timer interrupt is on from `deadline` until a later one is set; at once if it has passed.
  void set_deadline(units::Cycles deadline);
  // No interrupt until the next deadline is set.
  void clear_deadline();
};

}  // namespace drivers
