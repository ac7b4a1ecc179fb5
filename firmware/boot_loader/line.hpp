// SPDX-License-Identifier: Apache-2.0
// The serial line, as the loader needs it: waits for a byte asleep, sends by polling.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace boot_loader {

class Line {
 public:
  // At this speed, at a chip's clock of `clock_hz`; a frame under way is lost.
  static void configure(std::uint32_t baud, std::uint32_t clock_hz);

  // The next byte, or nothing where none has come for so many clocks.
  static std::optional<std::uint8_t> receive(std::uint32_t patience_clocks);
  static void send(std::span<const std::uint8_t> bytes);
  // Interrupts off, as after a reset.
  static void leave();
};

}  // namespace boot_loader
