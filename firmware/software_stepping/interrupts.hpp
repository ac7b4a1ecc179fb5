// SPDX-License-Identifier: Apache-2.0
// Keeps the timer interrupt out while its data are half done. Defined once per world.
#pragma once

#include <cstdint>

namespace software_stepping {

// Clocks since reset: the timer's count, read without the bus.
std::uint64_t long_clocks();

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

}  // namespace software_stepping
