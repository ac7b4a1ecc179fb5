// SPDX-License-Identifier: Apache-2.0
// A Verilated serial line with its driver, and a host at the other end of the wire.
#pragma once

#include "drivers/uart.hpp"

#include <gtest/gtest.h>

#include <Vuart.h>
#include <span>
#include <string>

#include "registers/uart_registers.hpp"
#include "tests/drivers/serial_host.hpp"
#include "tests/drivers/verilated_bus.hpp"

namespace tests {

using registers::uart::receive_depth;
using registers::uart::transmit_depth;

// Of `baud` on a chip that is clocked with `clock_hz`; the host's speed is off by `deviation`.
class UartLine {
 public:
  UartLine(std::uint32_t baud, std::uint32_t clock_hz, double deviation = 0)
      : host((1 + deviation) * clock_hz / baud) {
    chip->receive = 1;
    chip.after_clock = [this] { chip->receive = host.clock(chip->transmit != 0); };
    EXPECT_TRUE(uart.configure(baud, units::Hertz(clock_hz)));
  }

  // Until the host has sent everything, and a frame longer.
  void finish_sending() {
    while (host.sending()) chip.clock();
    chip.clock(50);
  }
  void finish_receiving() {
    while (!uart.transmit_idle()) chip.clock();
    chip.clock(50);
  }

  std::string read(std::size_t most) {
    std::string text(most, '\0');
    std::size_t count = 0;
    for (std::size_t more = 1; more != 0; count += more) {
      more = uart.read(std::span(text).subspan(count)).count;
    }
    text.resize(count);
    return text;
  }

  VerilatedPeripheral<Vuart> chip{registers::uart::base};
  SerialHost host;
  drivers::Uart uart;
};

inline UartLine fast_line() { return {1'000'000, 4'000'000}; }

inline std::string all_bytes(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += static_cast<char>(i * 7 + i / 256);
  return text;
}

}  // namespace tests
