// SPDX-License-Identifier: Apache-2.0
// Masks the timer interrupt while its data are inconsistent. Defined once per program.
#pragma once

#include <cstdint>

namespace software_stepping {

// Clocks since reset: the timer's count, read without the bus.
std::uint64_t long_clocks();
// Whether so many have passed: with fewer clocks than long_clocks() takes.
bool has_come(std::uint64_t clock);

// Enables the timer interrupt from now on, and sets the processor's clock counter to the timer's.
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

// Store the interrupt's registers of the tick to memory, and load them. The interrupt must
// be masked.
void registers_to_tick();
void tick_to_registers();

}  // namespace software_stepping
