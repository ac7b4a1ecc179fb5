// SPDX-License-Identifier: Apache-2.0
// The serial line to the host: bytes in, bytes out, nothing waits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "units/quantity.hpp"

namespace drivers {

// Errors on the line since the last Uart::clear_errors().
struct UartErrors {
  bool overrun{};  // bytes came faster than they were read, and were lost
  bool framing_error{};  // a byte had no stop bit and was dropped
  bool break_condition{};
  bool noise{};  // a byte was received although looks at its bits differed

  // Whether a byte was lost.
  constexpr bool any() const { return overrun || framing_error || break_condition; }
};

// Error counts since reset, modulo 2^16.
struct UartErrorCounts {
  std::uint16_t overruns{};  // lost bytes
  std::uint16_t framing_errors{};
  std::uint16_t breaks{};
  std::uint16_t noisy_bytes{};
};

// What Uart::read() has taken.
struct ReceivedBytes {
  std::size_t count{};
  bool gap_before_last{};  // right before the last of them something was lost
};

// Interrupt sources: levels, which last until the FIFO has been served.
struct UartAlarms {
  std::size_t receive_level{};  // at least so many bytes wait; 0 is never
  bool line_end{};  // the end of a line waits
  std::size_t transmit_space{};  // at least so much space is free; 0 is never
};

class Uart {
 public:
  // What the baud rate register needs for `baud`, rounded to nearest; nothing where that is less
  // than 4 clocks per bit, or no speed at all.
  static constexpr std::optional<std::uint32_t> increment(std::uint32_t baud, units::Hertz clock) {
    if (clock.count() == 0) return std::nullopt;
    const std::uint64_t bits_per_clock =
        ((std::uint64_t{baud} << 32) + clock.count() / 2) / clock.count();
    if (bits_per_clock == 0 || bits_per_clock > fastest_increment) return std::nullopt;
    return static_cast<std::uint32_t>(bits_per_clock);
  }

  // Sets the speed; a frame under way in either direction is lost, bytes that wait are kept. False,
  // with the line as it was, where the clock is too slow for it.
  [[nodiscard]] bool configure(std::uint32_t baud, units::Hertz clock);

  // Takes as many bytes as have come and as fit, but none beyond one that comes after a gap. The
  // span is no longer than the FIFO is deep (registers::uart::receive_depth).
  ReceivedBytes read(std::span<char> bytes);
  // The same up to the end of a line, at the latest. The second end and the first behind it are one
  // end: the first of them is taken with the next line.
  ReceivedBytes read_line(std::span<char> bytes);
  // Hands over as many bytes as there is space for, from the first on; returns how many.
  std::size_t write(std::span<const char> bytes);

  std::size_t receive_level() const;
  std::size_t transmit_space() const;
  // Everything has been sent, the last stop bit included.
  bool transmit_idle() const;

  UartErrors errors() const;
  UartErrorCounts error_counts() const;
  void clear_errors();

  // The received bytes contain the end of a line.
  bool line_waits() const;
  // What ends a line, of bytes that come from now on; after reset line feed and carriage return.
  void set_line_ends(char first, char second);

  void interrupt_on(const UartAlarms& alarms);

 private:
  static constexpr std::uint64_t fastest_increment = std::uint64_t{1} << 30;

  template <bool one_line>
  ReceivedBytes take(std::span<char> bytes);
  bool ends_line(unsigned char byte, bool is_first) const;

  unsigned char first_end_{}, second_end_{};
  bool after_second_end_{};  // the last byte that read_line() has taken
};

}  // namespace drivers
