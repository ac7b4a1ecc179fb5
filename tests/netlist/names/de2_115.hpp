// SPDX-License-Identifier: Apache-2.0
// Clocks and names in the netlist of the DE2-115.
#pragma once

#include "Vde2_115.h"

namespace tests {

class BoardNetlist : public Vde2_115 {
 public:
  using Vde2_115::Vde2_115;
};

namespace board {

// The second oscillator has 25 MHz: it changes its level in each clock.
inline constexpr unsigned watch_clocks = 1;

inline void set_clock(BoardNetlist& model, bool level) { model.clock_50mhz = level; }
inline void change_watch_clock(BoardNetlist& model) { model.clock_25mhz = model.clock_25mhz == 0; }
inline void set_receive(BoardNetlist& model, bool level) { model.uart_rxd = level; }
inline bool transmit(const BoardNetlist& model) { return model.uart_txd; }

}  // namespace board
}  // namespace tests
