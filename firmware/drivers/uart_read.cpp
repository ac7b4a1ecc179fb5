// SPDX-License-Identifier: Apache-2.0
// The loop over the received bytes, apart from the rest because it is compiled for speed.
#include "drivers/uart.hpp"
#include "platform/bus.hpp"
#include "registers/uart_registers.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace drivers {

namespace uart_registers = registers::uart;

[[gnu::noinline]] ReceivedBytes Uart::read(std::span<char> bytes) {
  // By masks, in one comparison: this is done for each byte.
  constexpr std::uint32_t flags = uart_registers::Data::valid_mask | uart_registers::Data::gap_mask;
  char* to = bytes.data();
  char* const end = to + bytes.size();
  bool gap = false;
  units::LoopBound<uart_registers::receive_depth> reads;
  for (; to != end; ++to) {
    reads.next();
    const std::uint32_t word = platform::bus_read(uart_registers::Data::address);
    *to = static_cast<char>(word);
    if ((word & flags) == uart_registers::Data::valid_mask) [[likely]] {
      units::happens<units::Event::byte_received>();
      continue;
    }
    if ((word & uart_registers::Data::valid_mask) == 0) break;
    units::happens<units::Event::byte_received>();
    gap = true;
    ++to;
    break;
  }
  return {.count = static_cast<std::size_t>(to - bytes.data()), .gap_before_last = gap};
}

}  // namespace drivers
