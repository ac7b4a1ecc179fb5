// SPDX-License-Identifier: Apache-2.0
// What is called how in the model of a ULX3S.
#pragma once

#include "sim/boards/motors.hpp"
#include "Vboard.h"
#include "Vboard___024root.h"

#define IN_BOARD(name) ulx3s__DOT__##name
#define IN_CORE(name) IN_BOARD(chip__DOT__core__DOT__##name)

namespace sim::board {

// Clocks of the chip for a change of the oscillator's level: 50 MHz against 2.4.
inline constexpr unsigned watch_clocks = 10;

inline void set_clock(Vboard& model, bool level) { model.clk_25mhz = level; }
inline void change_watch_clock(Vboard& model) {
  model.rootp->IN_BOARD(oscillator__DOT__level) ^= 1;
}
inline void set_receive(Vboard& model, bool level) {
  model.ftdi_txd = level;
  model.ftdi_ndtr = 0;  // a host has the port open
}
inline bool transmit(const Vboard& model) { return model.ftdi_rxd; }
inline Motors motors_of(const Vboard& model) { return motors_enabled_low(model); }
inline void set_end_stops(Vboard& model, unsigned levels) {
  model.end_stop = static_cast<CData>(levels);
}
inline bool is_released(const Vboard& model) {
  constexpr unsigned last = 15;
  return (model.rootp->IN_BOARD(reset_done) >> last & 1) != 0;
}

}  // namespace sim::board
