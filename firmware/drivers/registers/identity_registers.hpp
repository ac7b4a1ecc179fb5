// SPDX-License-Identifier: Apache-2.0
// Registers of `identity`. Generated from rtl/bus/identity.toml: do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

// What this chip is: design, version, clock and sizes.
namespace registers::identity {

inline constexpr std::uint32_t base = 0xF0000000u;

// Says that this is the design that the rest of the map belongs to.
struct Magic {
  static constexpr std::uint32_t address = base + 0x0u;
  enum class Word : std::uint32_t {
    stepfabric = 1397113154,
  };
  // The letters SFAB, S in the highest byte.
  std::uint32_t word{};

  static constexpr Magic decode([[maybe_unused]] std::uint32_t word) {
    return {
      .word = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return word;
  }
};

// Version of the design. The same major number means that old firmware still runs.
struct Version {
  static constexpr std::uint32_t address = base + 0x4u;
  // Changes when registers change their meaning.
  std::uint32_t major{};
  // Changes when something is added.
  std::uint32_t minor{};
  // Changes with every other release.
  std::uint32_t patch{};

  static constexpr Version decode([[maybe_unused]] std::uint32_t word) {
    return {
      .major = ((word >> 16u) & 0xFFFFu),
      .minor = ((word >> 8u) & 0xFFu),
      .patch = (word & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (major & 0xFFFFu) << 16u |
           (minor & 0xFFu) << 8u |
           (patch & 0xFFu);
  }
};

// The one clock of the chip.
struct Clock {
  static constexpr std::uint32_t address = base + 0x8u;
  // In hertz.
  std::uint32_t frequency_hz{};

  static constexpr Clock decode([[maybe_unused]] std::uint32_t word) {
    return {
      .frequency_hz = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return frequency_hz;
  }
};

// Memory at 0x80000000.
struct Memory {
  static constexpr std::uint32_t address = base + 0xCu;
  // In bytes.
  std::uint32_t size_bytes{};

  static constexpr Memory decode([[maybe_unused]] std::uint32_t word) {
    return {
      .size_bytes = word,
    };
  }
  constexpr std::uint32_t encode() const {
    return size_bytes;
  }
};

// Sizes of the step generator.
struct Motion {
  static constexpr std::uint32_t address = base + 0x10u;
  // Number of axes.
  std::uint32_t axes{};
  // Segments that its queue holds.
  std::uint32_t queue_depth{};

  static constexpr Motion decode([[maybe_unused]] std::uint32_t word) {
    return {
      .axes = (word & 0xFFu),
      .queue_depth = ((word >> 16u) & 0xFFFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (axes & 0xFFu) |
           (queue_depth & 0xFFFFu) << 16u;
  }
};

// Sizes of the thermal part.
struct Thermal {
  static constexpr std::uint32_t address = base + 0x14u;
  // Channels of the temperature converter.
  std::uint32_t sensors{};
  // Channels of the heater control.
  std::uint32_t heaters{};

  static constexpr Thermal decode([[maybe_unused]] std::uint32_t word) {
    return {
      .sensors = (word & 0xFFu),
      .heaters = ((word >> 8u) & 0xFFu),
    };
  }
  constexpr std::uint32_t encode() const {
    return (sensors & 0xFFu) |
           (heaters & 0xFFu) << 8u;
  }
};

}  // namespace registers::identity
