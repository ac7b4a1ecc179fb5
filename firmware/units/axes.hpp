// SPDX-License-Identifier: Apache-2.0
// The machine's axes in the order in which hardware, firmware and reports number them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace units {

enum class Axis : std::uint8_t { x, y, z, e };

// Axes that G-code moves. The step generator may have more, which then stay idle, but for a second
// extruder: E is one of two (drivers/step_generator).
inline constexpr std::size_t axis_count = 4;
inline constexpr std::array<char, axis_count> axis_letters{'X', 'Y', 'Z', 'E'};

template <class Value>
using PerAxis = std::array<Value, axis_count>;

constexpr std::size_t index_of(Axis axis) { return static_cast<std::size_t>(axis); }

// Some of the axes.
class AxisSet {
 public:
  constexpr AxisSet() = default;

  static constexpr AxisSet all() {
    AxisSet set;
    set.bits_ = (1u << axis_count) - 1;
    return set;
  }

  constexpr bool contains(Axis axis) const { return (bits_ >> index_of(axis) & 1u) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr void insert(Axis axis) {
    bits_ = static_cast<std::uint8_t>(bits_ | 1u << index_of(axis));
  }
  constexpr void remove(Axis axis) {
    bits_ = static_cast<std::uint8_t>(bits_ & ~(1u << index_of(axis)));
  }
  // Bit = index of the axis.
  constexpr std::uint32_t bits() const { return bits_; }
  constexpr bool operator==(const AxisSet&) const = default;

 private:
  std::uint8_t bits_{};
};

}  // namespace units
