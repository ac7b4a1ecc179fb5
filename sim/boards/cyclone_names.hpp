// SPDX-License-Identifier: Apache-2.0
// What is called how in the model of a board with a Cyclone and the pins of the interface board.
#pragma once

#include "sim/boards/cyclone_model.hpp"

namespace sim::board {

inline Motors motors_of(const Vboard& model) { return motors_enabled_low(model); }
inline void set_end_stops(Vboard& model, unsigned levels) {
  model.end_stop = static_cast<CData>(levels);
}

}  // namespace sim::board
