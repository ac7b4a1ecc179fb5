// SPDX-License-Identifier: Apache-2.0
// The serial line's registers behind byte spans.
#include "drivers/uart.hpp"

#include <algorithm>

#include "platform/bus.hpp"
#include "registers/uart_registers.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace drivers {

namespace uart_registers = registers::uart;

bool Uart::configure(std::uint32_t baud, units::Hertz clock) {
  const auto bits_per_clock = increment(baud, clock);
  if (!bits_per_clock) return false;
  platform::write(uart_registers::BaudRate{.increment = *bits_per_clock});
  return true;
}

std::size_t Uart::write(std::span<const char> bytes) {
  const std::size_t count = std::min(bytes.size(), transmit_space());
  units::LoopBound<uart_registers::transmit_depth> writes;
  for (const char byte : bytes.first(count)) {
    writes.next();
    platform::write(uart_registers::Data{
        .byte = static_cast<unsigned char>(byte), .valid = true, .gap = false});
    units::happens<units::Event::byte_sent>();
  }
  return count;
}

std::size_t Uart::receive_level() const {
  return platform::read<uart_registers::Status>().receive_level;
}

std::size_t Uart::transmit_space() const {
  return platform::read<uart_registers::Status>().transmit_space;
}

bool Uart::transmit_idle() const { return platform::read<uart_registers::Status>().transmit_idle; }

UartErrors Uart::errors() const {
  const auto status = platform::read<uart_registers::Status>();
  return {
      .overrun = status.overrun,
      .framing_error = status.framing_error,
      .break_condition = status.break_condition,
      .noise = status.noise,
  };
}

UartErrorCounts Uart::error_counts() const {
  return {
      .overruns = static_cast<std::uint16_t>(platform::read<uart_registers::Overruns>().count),
      .framing_errors =
          static_cast<std::uint16_t>(platform::read<uart_registers::FramingErrors>().count),
      .breaks = static_cast<std::uint16_t>(platform::read<uart_registers::Breaks>().count),
      .noisy_bytes = static_cast<std::uint16_t>(platform::read<uart_registers::NoisyBytes>().count),
  };
}

void Uart::clear_errors() {
  platform::write(uart_registers::Clear{
      .overrun = true, .framing_error = true, .break_condition = true, .noise = true});
}

bool Uart::line_waits() const { return platform::read<uart_registers::Status>().line_waits; }

void Uart::set_line_ends(char first, char second) {
  first_end_ = static_cast<unsigned char>(first);
  second_end_ = static_cast<unsigned char>(second);
  platform::write(uart_registers::LineEnds{
      .first = static_cast<unsigned char>(first),
      .second = static_cast<unsigned char>(second),
  });
}

void Uart::interrupt_on(const UartAlarms& alarms) {
  platform::write(uart_registers::Interrupts{
      .receive_threshold = static_cast<std::uint32_t>(alarms.receive_level),
      .on_line_end = alarms.line_end,
      .transmit_threshold = static_cast<std::uint32_t>(alarms.transmit_space),
  });
}

}  // namespace drivers
