// SPDX-License-Identifier: Apache-2.0
// Keeps the timer interrupt out while its data are half done. Defined once per world.
#pragma once

#include <cstdint>

namespace software_stepping {

// Clocks since reset: the timer's count, read without the bus.
std::uint64_t long_clocks();
// Whether so many have passed: with fewer clocks than long_clocks() takes.
bool has_come(std::uint64_t clock);

// Lets the timer interrupt in from now on, and sets the processor's clock counter to the timer's.
void begin_interrupts();

class WithoutInterrupts {
 public:
  WithoutInterrupts();
  WithoutInterrupts(const WithoutInterrupts&) = delete;
  WithoutInterrupts& operator=(const WithoutInterrupts&) = delete;
  ~WithoutInterrupts();

 private:
  std::uint32_t before_{};  // whether they were let in
};

// What the interrupt has of the tick in registers goes to the memory, and what is there into the
// registers. The interrupt must be kept out.
void registers_to_tick();
void tick_to_registers();

}  // namespace software_stepping
