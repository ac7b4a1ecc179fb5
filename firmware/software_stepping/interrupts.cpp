// SPDX-License-Identifier: Apache-2.0
// The timer interrupt of the chip, and what keeps it out. Only in the image.
#include "software_stepping/interrupts.hpp"

#include "drivers/registers/timer_registers.hpp"
#include "platform/bus.hpp"
#include "platform/processor.hpp"
#include "software_stepping/chip_stepper.hpp"

namespace software_stepping {
namespace {

constexpr std::uint32_t interrupts_enabled = 1u << 3;  // mstatus.MIE
constexpr std::uint32_t timer_interrupt_enabled = 1u << 7;  // mie.MTIE

// Calls attend() of the stepper; keeps every register but t0 itself, so that a tick that does not
// call it saves few (interrupt_entry.S).
[[gnu::always_inline]] inline void attend(Attention reason) {
  register Attention argument asm("t0") = reason;
  asm volatile("jal t1, attend_saving_all" : "+r"(argument) : : "t1", "memory");
}

}  // namespace

extern "C" {
[[gnu::used]] constinit Counters software_stepping_counters;
}

Stepper& chip_stepper() {
  static constinit Stepper stepper(software_stepping_counters);
  return stepper;
}

std::uint64_t long_clocks() {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t again;
  do {
    asm volatile("csrr %0, mcycleh" : "=r"(high));
    asm volatile("csrr %0, mcycle" : "=r"(low));
    asm volatile("csrr %0, mcycleh" : "=r"(again));
  } while (high != again);
  return std::uint64_t{high} << 32 | low;
}

void begin_interrupts() {
  namespace timer = registers::timer;
  const std::uint32_t low = platform::read<timer::TimeLow>().cycles;
  const std::uint32_t high = platform::read<timer::TimeHigh>().cycles;
  asm volatile("csrw mcycleh, %0" ::"r"(high));
  // So many clocks pass from the timer's answer to this.
  asm volatile("csrw mcycle, %0" ::"r"(low + 8));
  asm volatile("csrs mie, %0" ::"r"(timer_interrupt_enabled));
  asm volatile("csrs mstatus, %0" ::"r"(interrupts_enabled) : "memory");
}

WithoutInterrupts::WithoutInterrupts() {
  asm volatile("csrrci %0, mstatus, 8" : "=r"(before_)::"memory");
}

WithoutInterrupts::~WithoutInterrupts() {
  asm volatile("csrs mstatus, %0" ::"r"(before_ & interrupts_enabled) : "memory");
}

extern "C" [[gnu::used]] void attend_to_stepper(Attention reason) { chip_stepper().attend(reason); }

extern "C" [[gnu::used, gnu::interrupt("machine"), gnu::optimize("O3")]] void timer_interrupt() {
  on_timer(chip_stepper().tick(), [](Attention reason) { attend(reason); });
}

}  // namespace software_stepping
