// SPDX-License-Identifier: Apache-2.0
// The program of the chip: says `start`, then echoes what it receives.
#include "drivers/registers/identity_registers.hpp"
#include "drivers/registers/uart_registers.hpp"
#include "platform/bus.hpp"
#include "platform/processor.hpp"

int main() {
  namespace uart = registers::uart;
  constexpr std::uint64_t baud = 250'000;
  const std::uint32_t clock_hz = platform::read<registers::identity::Clock>().frequency_hz;
  const auto increment = static_cast<std::uint32_t>((baud << 32) / clock_hz);
  platform::write(uart::BaudRate{.increment = increment});
  for (const char* text = "start\n"; *text != '\0'; ++text) {
    platform::write(uart::Data{.byte = static_cast<std::uint8_t>(*text)});
  }
  platform::write(uart::Interrupts{.receive_threshold = 1});
  platform::wake_by(platform::WakeSource::uart_receive, true);
  for (;;) {
    platform::sleep();
    const auto data = platform::read<uart::Data>();
    if (data.valid) platform::write(uart::Data{.byte = data.byte});
  }
}
