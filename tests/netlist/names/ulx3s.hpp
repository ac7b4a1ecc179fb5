// SPDX-License-Identifier: Apache-2.0
// Clocks and names in the netlist of the ULX3S.
#pragma once

#include "Vulx3s.h"
#include "Vulx3s___024root.h"

namespace tests {

class BoardNetlist : public Vulx3s {
 public:
  using Vulx3s::Vulx3s;
};

namespace board {

// 50 MHz against half of 2.4: the oscillator changes its level so seldom.
inline constexpr unsigned watch_clocks = 10;

inline void set_clock(BoardNetlist& model, bool level) { model.clk_25mhz = level; }
inline void change_watch_clock(BoardNetlist& model) {
  model.rootp->ulx3s__DOT__oscillator_0__DOT__level ^= 1;
}
inline void set_receive(BoardNetlist& model, bool level) {
  model.ftdi_txd = level;
  model.ftdi_ndtr = 0;  // a host has the port open
}
inline bool transmit(const BoardNetlist& model) { return model.ftdi_rxd; }

}  // namespace board
}  // namespace tests
