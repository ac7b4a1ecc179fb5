// SPDX-License-Identifier: Apache-2.0
// Stimuli and outputs of the step generator, clock by clock: the format of the comparisons.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

namespace motion_reference {

// Something that happens in one clock, counted from 0 at the end of reset.
struct Stimulus {
  enum class Kind : std::uint8_t {
    write,  // a bus write begins: the registers see it in the next clock
    inputs,  // end stops in bits 7:0, emergency stop in 8, start in 9 of value, from this clock on
  };
  std::uint64_t clock{};
  Kind kind{};
  std::uint32_t address{};
  std::uint32_t value{};

  bool operator==(const Stimulus&) const = default;
};

// Pins of all axes, bit = axis.
struct Pins {
  std::uint32_t step{};
  std::uint32_t direction{};

  bool operator==(const Pins&) const = default;
};

// The pins from this clock on.
struct Edge {
  std::uint64_t clock{};
  Pins pins{};

  bool operator==(const Edge&) const = default;
};

// One a line: `clock kind offset value` (decimal, decimal, hexadecimal offset in the 4 KiB
// page, hexadecimal), and `clock step direction` (decimal, hexadecimal), which the VHDL bench
// reads and writes.
void save(std::ostream& out, const std::vector<Stimulus>& stimuli);
std::vector<Stimulus> load_stimuli(std::istream& in, std::uint32_t base);
void save(std::ostream& out, const std::vector<Edge>& edges);

}  // namespace motion_reference
