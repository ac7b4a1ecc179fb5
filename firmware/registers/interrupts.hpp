// SPDX-License-Identifier: Apache-2.0
// Interrupts. Generated from the descriptions of the peripherals: do not edit.
// clang-format off
#pragma once

#include <cstdint>

namespace registers {

// Bits of the processor's registers mie and mip.
enum class Interrupt : std::uint32_t {
  // The deadline has been reached.
  timer = 1u << 7,
  // Received bytes wait: so many as asked for, or a whole line.
  uart_receive = 1u << 16,
  // The queue holds at most control.queue_threshold segments.
  queue_threshold = 1u << 17,
  // A stop waits for its acknowledgement.
  motion_stopped = 1u << 18,
  // A channel is tripped, or something opened the supply.
  heater_trip = 1u << 19,
  // So many bytes as asked for may be written.
  uart_transmit = 1u << 20,
};

}  // namespace registers
