// SPDX-License-Identifier: Apache-2.0
// Clocks from one instruction to the next, by the processor's table of times.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/processor/decoder.hpp"

namespace processor {
class TimingTable;
}

namespace timing {

struct Costs {
  explicit Costs(const processor::TimingTable& table);

  unsigned simple, multiplication, bit_manipulation, division;
  unsigned load, store, bus_load, bus_store;
  unsigned not_taken, taken, predicted_not_taken, predicted_taken;  // of branches
  unsigned jump, jump_register, fence_i, csr, trap_return, wait, hazard;

  // `taken` of branches; `on_bus` of loads and stores.
  unsigned of(const processor::Instruction& instruction, bool taken, bool on_bus) const;
  // In addition: `next` reads what comes late.
  unsigned between(const processor::Instruction& instruction,
                   const processor::Instruction& next) const;
};

}  // namespace timing
