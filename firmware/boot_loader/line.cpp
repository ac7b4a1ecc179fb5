// SPDX-License-Identifier: Apache-2.0
// Registers of uart and timer.
#include "boot_loader/line.hpp"

#include "drivers/timer.hpp"
#include "platform/bus.hpp"
#include "platform/processor.hpp"
#include "registers/uart_registers.hpp"

namespace boot_loader {

namespace uart = registers::uart;

namespace {

void wake_by_line_and_timer(bool enabled) {
  platform::wake_by(platform::WakeSource::timer, enabled);
  platform::wake_by(platform::WakeSource::uart_receive, enabled);
  platform::write(uart::Interrupts{.receive_threshold = enabled ? 1u : 0u});
}

}  // namespace

// baud * 2^32 / clock_hz, digit by digit: a division of 64 bits would be half as large as
// the loader.
void Line::configure(std::uint32_t baud, std::uint32_t clock_hz) {
  std::uint32_t increment = 0, rest = baud;
  for (int digit = 0; digit < 32; ++digit) {
    rest <<= 1;
    increment <<= 1;
    if (rest >= clock_hz) {
      rest -= clock_hz;
      increment |= 1;
    }
  }
  platform::write(uart::BaudRate{.increment = increment});
}

std::optional<std::uint8_t> Line::receive(std::uint32_t patience_clocks) {
  drivers::Timer timer;
  const auto deadline = timer.now() + units::Cycles(patience_clocks);
  timer.set_deadline(deadline);
  wake_by_line_and_timer(true);
  for (;;) {
    const auto data = platform::read<uart::Data>();
    if (data.valid) return static_cast<std::uint8_t>(data.byte);
    if (timer.now() >= deadline) return std::nullopt;
    platform::sleep();
  }
}

void Line::send(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    while (platform::read<uart::Status>().transmit_space == 0) {
    }
    platform::write(uart::Data{.byte = byte});
  }
}

void Line::leave() {
  wake_by_line_and_timer(false);
  drivers::Timer().clear_deadline();
}

}  // namespace boot_loader
