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
  static constexpr unsigned word_low = 0, word_width = 32;
  static constexpr std::uint32_t word_max = 0xFFFFFFFFu, word_mask = word_max << word_low;
  enum class Word : std::uint32_t {
    stepfabric = 1397113154,
  };
  // The letters SFAB, S in the highest byte.
  Word word{};

  [[gnu::always_inline]] static constexpr Magic decode([[maybe_unused]] std::uint32_t word) {
    return {
      .word = static_cast<Word>(word),
    };
  }
  constexpr std::uint32_t encode() const {
    return static_cast<std::uint32_t>(word);
  }
};

// Version of the design. The same major number means that old firmware still runs.
struct Version {
  static constexpr std::uint32_t address = base + 0x4u;
  static constexpr unsigned major_low = 16, major_width = 16;
  static constexpr std::uint32_t major_max = 0xFFFFu, major_mask = major_max << major_low;
  static constexpr unsigned minor_low = 8, minor_width = 8;
  static constexpr std::uint32_t minor_max = 0xFFu, minor_mask = minor_max << minor_low;
  static constexpr unsigned patch_low = 0, patch_width = 8;
  static constexpr std::uint32_t patch_max = 0xFFu, patch_mask = patch_max << patch_low;
  // Changes when registers change their meaning.
  std::uint32_t major{};
  // Changes when something is added.
  std::uint32_t minor{};
  // Changes with every other release.
  std::uint32_t patch{};

  [[gnu::always_inline]] static constexpr Version decode([[maybe_unused]] std::uint32_t word) {
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
  static constexpr unsigned frequency_hz_low = 0, frequency_hz_width = 32;
  static constexpr std::uint32_t frequency_hz_max = 0xFFFFFFFFu, frequency_hz_mask = frequency_hz_max << frequency_hz_low;
  // In hertz.
  std::uint32_t frequency_hz{};

  [[gnu::always_inline]] static constexpr Clock decode([[maybe_unused]] std::uint32_t word) {
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
  static constexpr unsigned size_bytes_low = 0, size_bytes_width = 32;
  static constexpr std::uint32_t size_bytes_max = 0xFFFFFFFFu, size_bytes_mask = size_bytes_max << size_bytes_low;
  // In bytes.
  std::uint32_t size_bytes{};

  [[gnu::always_inline]] static constexpr Memory decode([[maybe_unused]] std::uint32_t word) {
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
  static constexpr unsigned axes_low = 0, axes_width = 8;
  static constexpr std::uint32_t axes_max = 0xFFu, axes_mask = axes_max << axes_low;
  static constexpr unsigned queue_depth_low = 16, queue_depth_width = 16;
  static constexpr std::uint32_t queue_depth_max = 0xFFFFu, queue_depth_mask = queue_depth_max << queue_depth_low;
  // Number of axes.
  std::uint32_t axes{};
  // Segments that its queue holds.
  std::uint32_t queue_depth{};

  [[gnu::always_inline]] static constexpr Motion decode([[maybe_unused]] std::uint32_t word) {
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
  static constexpr unsigned sensors_low = 0, sensors_width = 8;
  static constexpr std::uint32_t sensors_max = 0xFFu, sensors_mask = sensors_max << sensors_low;
  static constexpr unsigned heaters_low = 8, heaters_width = 8;
  static constexpr std::uint32_t heaters_max = 0xFFu, heaters_mask = heaters_max << heaters_low;
  // Channels of the temperature converter.
  std::uint32_t sensors{};
  // Channels of the heater control.
  std::uint32_t heaters{};

  [[gnu::always_inline]] static constexpr Thermal decode([[maybe_unused]] std::uint32_t word) {
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
