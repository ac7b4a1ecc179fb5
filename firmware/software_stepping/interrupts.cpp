// SPDX-License-Identifier: Apache-2.0
// The timer interrupt of the chip, and its masking. Only in the image.
#include "software_stepping/interrupts.hpp"

#include <cstddef>

#include "platform/bus.hpp"
#include "registers/end_stops_registers.hpp"
#include "registers/interrupts.hpp"
#include "registers/step_pins_registers.hpp"
#include "registers/timer_registers.hpp"
#include "software_stepping/chip_stepper.hpp"

// In tick.S.
extern "C" const software_stepping::Ways tick_ways;

namespace software_stepping {
namespace {

constexpr std::uint32_t interrupts_enabled = 1u << 3;  // mstatus.MIE
constexpr auto timer_interrupt_enabled = static_cast<std::uint32_t>(registers::Interrupt::timer);

// As tick.S counts them.
static_assert(offsetof(Block, interval_fraction) == 12);
static_assert(offsetof(Block, begins_line) == 32);
static_assert(offsetof(Block, largest_change) == 48);
static_assert(offsetof(Block, line) == 60);
static_assert(offsetof(Line, steps) == 12);
static_assert(offsetof(Line, errors) == 28);
static_assert(offsetof(Line, direction) == 52);
static_assert(offsetof(Tick, errors) == 8);
static_assert(offsetof(Tick, deadline_high) == 32);
static_assert(offsetof(Tick, trap_base) == 40);

// As tick.S writes them: the upper 20 bits of a peripheral, and the places of its registers.
static_assert(registers::step_pins::base == 0xF0008u << 12);
static_assert(registers::step_pins::Step::address == registers::step_pins::base + 4);
static_assert(registers::step_pins::Direction::address == registers::step_pins::base + 8);
static_assert(registers::timer::base == 0xF0002u << 12);
static_assert(registers::timer::CompareLow::address == registers::timer::base + 8);
static_assert(registers::timer::CompareHigh::address == registers::timer::base + 12);
static_assert(registers::end_stops::base == 0xF0004u << 12);
static_assert(registers::end_stops::Status::address == registers::end_stops::base);

}  // namespace

extern "C" {
[[gnu::used]] constinit Counters software_stepping_counters;
// Near the global pointer, where an instruction reaches it.
[[gnu::used, gnu::section(".sdata.software_stepping")]] constinit Tick software_stepping_tick;
}

const Ways& ways() { return tick_ways; }

Stepper& chip_stepper() {
  static constinit Stepper stepper(software_stepping_tick, software_stepping_counters);
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

// The upper half is read first: where the lower one wraps in between, the answer comes with the
// next call.
bool has_come(std::uint64_t clock) {
  std::uint32_t high;
  asm volatile("csrr %0, mcycleh" : "=r"(high));
  const auto clock_high = static_cast<std::uint32_t>(clock >> 32);
  if (high != clock_high) return high > clock_high;
  std::uint32_t low;
  asm volatile("csrr %0, mcycle" : "=r"(low));
  return low >= static_cast<std::uint32_t>(clock);
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

void registers_to_tick() { asm volatile("jal t0, registers_to_tick" ::: "t0", "memory"); }
void tick_to_registers() { asm volatile("jal t0, tick_to_registers" ::: "t0", "memory"); }

extern "C" [[gnu::used]] void attend_to_stepper(Attention reason) { chip_stepper().attend(reason); }

}  // namespace software_stepping
