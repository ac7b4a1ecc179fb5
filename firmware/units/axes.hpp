// SPDX-License-Identifier: Apache-2.0
// The machine's axes in the order in which hardware, firmware and reports number them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace units {

enum class Axis : std::uint8_t { x, y, z, e };

// Axes that G-code moves; the step generator may have more (a second extruder), which then stay idle.
inline constexpr std::size_t axis_count = 4;
inline constexpr std::array<char, axis_count> axis_letters{'X', 'Y', 'Z', 'E'};

template <class Value>
using PerAxis = std::array<Value, axis_count>;

constexpr std::size_t index_of(Axis axis) { return static_cast<std::size_t>(axis); }

}  // namespace units
