// SPDX-License-Identifier: Apache-2.0
// Registers of `uart`. Generated from rtl/serial/uart.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// Serial line with FIFOs: 8 data bits, no parity, 1 stop bit, at least 4 clocks per bit.
namespace registers::uart {

inline constexpr std::uint32_t base = 0xF0001000u;

// Bytes that the FIFO of received ones holds.
inline constexpr std::uint32_t receive_depth = 2048;

// Bytes that the FIFO of those to be sent holds.
inline constexpr std::uint32_t transmit_depth = 512;

// Speed of the line. A write restarts both directions; the FIFOs keep their contents.
struct BaudRate {
  static constexpr std::uint32_t address = base + 0x0u;
  static constexpr unsigned increment_low = 0, increment_width = 32;
  static constexpr std::uint32_t increment_max = 0xFFFFFFFFu, increment_mask = increment_max << increment_low;
  // Bits per clock in 2^-32: baud rate * 2^32 / clock frequency, at most 2^30. 0 is off.
  std::uint32_t increment{};

  [[gnu::always_inline]] static constexpr BaudRate decode([[maybe_unused]] std::uint32_t word) {
    return {
      .increment = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return increment;
  }
};

// What the line is doing. The four flags stay until they are cleared.
struct Status {
  static constexpr std::uint32_t address = base + 0x4u;
  static constexpr unsigned receive_level_low = 0, receive_level_width = 12;
  static constexpr std::uint32_t receive_level_max = 0xFFFu, receive_level_mask = receive_level_max << receive_level_low;
  static constexpr unsigned transmit_space_low = 12, transmit_space_width = 12;
  static constexpr std::uint32_t transmit_space_max = 0xFFFu, transmit_space_mask = transmit_space_max << transmit_space_low;
  static constexpr unsigned transmit_idle_bit = 24;
  static constexpr std::uint32_t transmit_idle_mask = 1u << transmit_idle_bit;
  static constexpr unsigned overrun_bit = 25;
  static constexpr std::uint32_t overrun_mask = 1u << overrun_bit;
  static constexpr unsigned framing_error_bit = 26;
  static constexpr std::uint32_t framing_error_mask = 1u << framing_error_bit;
  static constexpr unsigned break_condition_bit = 27;
  static constexpr std::uint32_t break_condition_mask = 1u << break_condition_bit;
  static constexpr unsigned noise_bit = 28;
  static constexpr std::uint32_t noise_mask = 1u << noise_bit;
  static constexpr unsigned line_waits_bit = 29;
  static constexpr std::uint32_t line_waits_mask = 1u << line_waits_bit;
  // Received bytes that wait to be read.
  std::uint32_t receive_level{};
  // Bytes that may be written now.
  std::uint32_t transmit_space{};
  // Everything written has left, the last stop bit included.
  bool transmit_idle{};
  // A received byte was lost because the FIFO was full.
  bool overrun{};
  // A byte without a stop bit came and was dropped.
  bool framing_error{};
  // The line was low for a whole frame.
  bool break_condition{};
  // The three looks at a bit of a byte differed; the majority counted. Means noise from 16 clocks per bit on.
  bool noise{};
  // Among the bytes that wait is one that ends a line. Not a flag: it ends when the last such byte is read.
  bool line_waits{};

  [[gnu::always_inline]] static constexpr Status decode([[maybe_unused]] std::uint32_t word) {
    return {
      .receive_level = (word & 0xFFFu),
      .transmit_space = ((word >> 12u) & 0xFFFu),
      .transmit_idle = ((word >> 24u) & 0x1u) != 0,
      .overrun = ((word >> 25u) & 0x1u) != 0,
      .framing_error = ((word >> 26u) & 0x1u) != 0,
      .break_condition = ((word >> 27u) & 0x1u) != 0,
      .noise = ((word >> 28u) & 0x1u) != 0,
      .line_waits = ((word >> 29u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (receive_level & 0xFFFu) |
           (transmit_space & 0xFFFu) << 12u |
           (transmit_idle ? 1u : 0u) << 24u |
           (overrun ? 1u : 0u) << 25u |
           (framing_error ? 1u : 0u) << 26u |
           (break_condition ? 1u : 0u) << 27u |
           (noise ? 1u : 0u) << 28u |
           (line_waits ? 1u : 0u) << 29u;
  }
};

// Clears those flags of `status` whose bit is written as 1.
struct Clear {
  static constexpr std::uint32_t address = base + 0x8u;
  static constexpr unsigned overrun_bit = 0;
  static constexpr std::uint32_t overrun_mask = 1u << overrun_bit;
  static constexpr unsigned framing_error_bit = 1;
  static constexpr std::uint32_t framing_error_mask = 1u << framing_error_bit;
  static constexpr unsigned break_condition_bit = 2;
  static constexpr std::uint32_t break_condition_mask = 1u << break_condition_bit;
  static constexpr unsigned noise_bit = 3;
  static constexpr std::uint32_t noise_mask = 1u << noise_bit;
  // Clear `overrun`.
  bool overrun{};
  // Clear `framing_error`.
  bool framing_error{};
  // Clear `break_condition`.
  bool break_condition{};
  // Clear `noise`.
  bool noise{};

  [[gnu::always_inline]] static constexpr Clear decode([[maybe_unused]] std::uint32_t word) {
    return {
      .overrun = (word & 0x1u) != 0,
      .framing_error = ((word >> 1u) & 0x1u) != 0,
      .break_condition = ((word >> 2u) & 0x1u) != 0,
      .noise = ((word >> 3u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (overrun ? 1u : 0u) |
           (framing_error ? 1u : 0u) << 1u |
           (break_condition ? 1u : 0u) << 2u |
           (noise ? 1u : 0u) << 3u;
  }
};

// Read: takes the oldest received byte. Write: sends a byte; without space it is dropped.
struct Data {
  static constexpr std::uint32_t address = base + 0xCu;
  static constexpr unsigned byte_low = 0, byte_width = 8;
  static constexpr std::uint32_t byte_max = 0xFFu, byte_mask = byte_max << byte_low;
  static constexpr unsigned valid_bit = 8;
  static constexpr std::uint32_t valid_mask = 1u << valid_bit;
  static constexpr unsigned gap_bit = 9;
  static constexpr std::uint32_t gap_mask = 1u << gap_bit;
  // The byte.
  std::uint32_t byte{};
  // Read: 1 if there was a byte. Write: ignored.
  bool valid{};
  // Read: 1 if something was lost right before this byte, to overrun, framing error or break. Write: ignored.
  bool gap{};

  [[gnu::always_inline]] static constexpr Data decode([[maybe_unused]] std::uint32_t word) {
    return {
      .byte = (word & 0xFFu),
      .valid = ((word >> 8u) & 0x1u) != 0,
      .gap = ((word >> 9u) & 0x1u) != 0,
    };
  }
  constexpr std::uint32_t encode() const {
    return (byte & 0xFFu) |
           (valid ? 1u : 0u) << 8u |
           (gap ? 1u : 0u) << 9u;
  }
};

// When to interrupt. All are levels: they end when the FIFO has been served.
struct Interrupts {
  static constexpr std::uint32_t address = base + 0x10u;
  static constexpr unsigned receive_threshold_low = 0, receive_threshold_width = 12;
  static constexpr std::uint32_t receive_threshold_max = 0xFFFu, receive_threshold_mask = receive_threshold_max << receive_threshold_low;
  static constexpr unsigned on_line_end_bit = 12;
  static constexpr std::uint32_t on_line_end_mask = 1u << on_line_end_bit;
  static constexpr unsigned transmit_threshold_low = 16, transmit_threshold_width = 12;
  static constexpr std::uint32_t transmit_threshold_max = 0xFFFu, transmit_threshold_mask = transmit_threshold_max << transmit_threshold_low;
  // Interrupt while at least this many bytes wait; 1: any, 0: never.
  std::uint32_t receive_threshold{};
  // Interrupt while `status.line_waits`, however few bytes wait.
  bool on_line_end{};
  // Interrupt while at least this many bytes may be written; 0: never.
  std::uint32_t transmit_threshold{};

  [[gnu::always_inline]] static constexpr Interrupts decode([[maybe_unused]] std::uint32_t word) {
    return {
      .receive_threshold = (word & 0xFFFu),
      .on_line_end = ((word >> 12u) & 0x1u) != 0,
      .transmit_threshold = ((word >> 16u) & 0xFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (receive_threshold & 0xFFFu) |
           (on_line_end ? 1u : 0u) << 12u |
           (transmit_threshold & 0xFFFu) << 16u;
  }
};

// How often bytes were lost.
struct Overruns {
  static constexpr std::uint32_t address = base + 0x14u;
  static constexpr unsigned count_low = 0, count_width = 16;
  static constexpr std::uint32_t count_max = 0xFFFFu, count_mask = count_max << count_low;
  // Lost bytes since reset, modulo 2^16.
  std::uint32_t count{};

  [[gnu::always_inline]] static constexpr Overruns decode([[maybe_unused]] std::uint32_t word) {
    return {
      .count = (word & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (count & 0xFFFFu);
  }
};

// How often a stop bit was missing.
struct FramingErrors {
  static constexpr std::uint32_t address = base + 0x18u;
  static constexpr unsigned count_low = 0, count_width = 16;
  static constexpr std::uint32_t count_max = 0xFFFFu, count_mask = count_max << count_low;
  // Framing errors since reset, modulo 2^16.
  std::uint32_t count{};

  [[gnu::always_inline]] static constexpr FramingErrors decode([[maybe_unused]] std::uint32_t word) {
    return {
      .count = (word & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (count & 0xFFFFu);
  }
};

// How often the line was low for a whole frame.
struct Breaks {
  static constexpr std::uint32_t address = base + 0x1Cu;
  static constexpr unsigned count_low = 0, count_width = 16;
  static constexpr std::uint32_t count_max = 0xFFFFu, count_mask = count_max << count_low;
  // Break conditions since reset, modulo 2^16.
  std::uint32_t count{};

  [[gnu::always_inline]] static constexpr Breaks decode([[maybe_unused]] std::uint32_t word) {
    return {
      .count = (word & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (count & 0xFFFFu);
  }
};

// How many bytes were received although looks at their bits differed.
struct NoisyBytes {
  static constexpr std::uint32_t address = base + 0x20u;
  static constexpr unsigned count_low = 0, count_width = 16;
  static constexpr std::uint32_t count_max = 0xFFFFu, count_mask = count_max << count_low;
  // Noisy bytes since reset, modulo 2^16.
  std::uint32_t count{};

  [[gnu::always_inline]] static constexpr NoisyBytes decode([[maybe_unused]] std::uint32_t word) {
    return {
      .count = (word & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (count & 0xFFFFu);
  }
};

// The bytes that end a line, for `status.line_waits`. A write counts for bytes that come after it.
struct LineEnds {
  static constexpr std::uint32_t address = base + 0x24u;
  static constexpr unsigned first_low = 0, first_width = 8;
  static constexpr std::uint32_t first_max = 0xFFu, first_mask = first_max << first_low;
  static constexpr unsigned second_low = 8, second_width = 8;
  static constexpr std::uint32_t second_max = 0xFFu, second_mask = second_max << second_low;
  // One of them: line feed after reset.
  std::uint32_t first{};
  // The other: carriage return after reset. May be the same as the first.
  std::uint32_t second{};

  [[gnu::always_inline]] static constexpr LineEnds decode([[maybe_unused]] std::uint32_t word) {
    return {
      .first = (word & 0xFFu),
      .second = ((word >> 8u) & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (first & 0xFFu) |
           (second & 0xFFu) << 8u;
  }
};

}  // namespace registers::uart
