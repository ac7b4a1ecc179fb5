// SPDX-License-Identifier: Apache-2.0
// What is called how in the model of a DE2-70 with the pins of the printer of 2012.
#pragma once

#include <initializer_list>
#include <stdexcept>

#include "sim/boards/cyclone_model.hpp"

namespace sim::board {

// A high RESET enables a driver. The fifth motor is a second one of Z, and does as the first.
inline Motors motors_of(const Vboard& model) {
  constexpr unsigned first_z = 2, second_z = 4, without_second = all_motors & ~(1U << second_z);
  for (const unsigned pins : {model.step, model.direction, model.motor_reset_n}) {
    if ((pins >> first_z & 1U) != (pins >> second_z & 1U)) {
      throw std::runtime_error("the motors of Z do not do the same");
    }
  }
  return {model.step & without_second, model.direction & without_second,
          model.motor_reset_n & without_second};
}

// X Y Z; the others are not there.
inline void set_end_stops(Vboard& model, unsigned levels) {
  model.end_stop = static_cast<CData>(levels & 7U);
}

}  // namespace sim::board
