// SPDX-License-Identifier: Apache-2.0
// What is called alike in the models of all boards with a Cyclone. BOARD is the name of one,
// BOARD_WATCH_CLOCK that of its second oscillator.
#pragma once

#include "sim/boards/motors.hpp"
#include "Vboard.h"
#include "Vboard___024root.h"

#define JOINED_NAMES(board, rest) board##__DOT__##rest
#define NAMES_OF(board, rest) JOINED_NAMES(board, rest)
#define IN_BOARD(name) NAMES_OF(BOARD, name)
#define IN_CORE(name) IN_BOARD(board__DOT__chip__DOT__core__DOT__##name)

namespace sim::board {

// Clocks of the chip for a change of the second oscillator's level: half of the frequency, as on a
// DE2-115; a DE2-70 has somewhat more.
inline constexpr unsigned watch_clocks = 1;

inline void set_clock(Vboard& model, bool level) { model.clock_50mhz = level; }
inline void change_watch_clock(Vboard& model) {
  model.BOARD_WATCH_CLOCK = model.BOARD_WATCH_CLOCK == 0;
}
inline void set_receive(Vboard& model, bool level) { model.uart_rxd = level; }
inline bool transmit(const Vboard& model) { return model.uart_txd; }
inline bool is_released(const Vboard& model) { return model.rootp->IN_BOARD(board__DOT__released); }

}  // namespace sim::board
