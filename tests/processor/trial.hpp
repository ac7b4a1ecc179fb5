// SPDX-License-Identifier: Apache-2.0
// Executes instructions one after the other on the chip, and records whether and how each trapped.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/processor/encode.hpp"

namespace processor {

// What the handler of a trap finds.
struct TrapFindings {
  std::uint32_t cause = 0;  // mcause
  std::uint32_t address = 0;  // mepc
  std::uint32_t value = 0;  // mtval

  bool operator==(const TrapFindings&) const = default;
};

// What one instruction did.
struct Outcome {
  encode::Word instruction = 0;
  std::uint32_t address = 0;
  // Nothing where it was completed.
  std::optional<TrapFindings> trap;
  // What it wrote, where it was completed and has a destination.
  std::uint32_t value = 0;
};

// What instructions that are tried may use, and must leave as it is.
namespace trial {
constexpr encode::Word base = 27;  // points into memory that holds nothing, 2 KiB on either side
constexpr encode::Word ones = 26;  // all ones
constexpr encode::Word destination = 6;  // may be written
}  // namespace trial

// All of them have `bytes` bytes, 2 or 4. None may jump, sleep, or change mtvec: what is
// tried must come back. Throws std::runtime_error where the chip did not come through all of
// them in their order.
std::vector<Outcome> try_instructions(const std::vector<encode::Word>& instructions,
                                      unsigned bytes);

}  // namespace processor
