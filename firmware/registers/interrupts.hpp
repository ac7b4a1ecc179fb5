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
  // Received bytes wait: as many as the threshold, or a whole line.
  uart_receive = 1u << 16,
  // The queue holds at most control.queue_threshold segments.
  queue_threshold = 1u << 17,
  // A stop waits for its acknowledgement.
  motion_stopped = 1u << 18,
  // A channel is tripped, or something opened the supply.
  heater_trip = 1u << 19,
  // There is room for as many bytes as the threshold.
  uart_transmit = 1u << 20,
};

}  // namespace registers
