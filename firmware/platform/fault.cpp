// SPDX-License-Identifier: Apache-2.0
// Reports a trap and halts. It uses registers only, because drivers and tasks may be broken.
#include "platform/fault.hpp"

#include "platform/bus.hpp"
#include "registers/heater_control_registers.hpp"
#include "registers/step_generator_registers.hpp"
#include "registers/uart_registers.hpp"
#include "units/loop_bound.hpp"

namespace platform {
namespace {

// A uart that never becomes free (its line switched off) must not keep the processor from halting.
constexpr std::uint32_t patience_reads = 1'000'000;

void put(char character) {
  units::LoopBound<patience_reads> reads;
  for (std::uint32_t i = 0; i < patience_reads; ++i) {
    reads.next();
    if (read<registers::uart::Status>().transmit_space != 0) break;
  }
  write(registers::uart::Data{.byte = static_cast<std::uint8_t>(character)});
}

void put(const char* text) {
  constexpr std::uint32_t longest = 64;  // none of the texts below or of halt() is longer
  units::LoopBound<longest> characters;
  for (; *text != '\0'; ++text) {
    characters.next();
    put(*text);
  }
}

void put_hexadecimal(std::uint32_t value) {
  put("0x");
  for (int shift = 28; shift >= 0; shift -= 4) put("0123456789abcdef"[value >> shift & 0xFu]);
}

// Causes as in the RISC-V privileged architecture, table "machine cause register values".
const char* name_of(std::uint32_t cause) {
  constexpr std::uint32_t interrupt = 0x8000'0000;
  if ((cause & interrupt) != 0) return "unexpected interrupt";
  switch (cause) {
    case 0:
      return "instruction address misaligned";
    case 1:
      return "instruction access fault";
    case 2:
      return "illegal instruction";
    case 3:
      return "breakpoint";
    case 4:
      return "load address misaligned";
    case 5:
      return "load access fault";
    case 6:
      return "store address misaligned";
    case 7:
      return "store access fault";
    case 11:
      return "environment call";
    default:
      return "unknown trap";
  }
}

void stop_everything() {
  asm volatile("csrci mstatus, 8");  // the image that makes the steps in an interrupt makes no more
  using HeaterDuty = registers::heater_control::Duty;
  for (std::size_t channel = 0; channel < HeaterDuty::count; ++channel) {
    write(channel, HeaterDuty{});
  }
  write(registers::step_generator::Command{.flush = true, .stop = true});
}

[[noreturn]] void end() {
  put("Error:Printer halted. kill() called!\n");
  asm volatile("csrw mie, zero");
  for (;;) asm volatile("wfi");
}

}  // namespace

extern "C" [[gnu::used]] void report_trap(std::uint32_t cause, std::uint32_t program_counter,
                                          std::uint32_t address, std::uint32_t stack_pointer,
                                          std::uint32_t return_address) {
  stop_everything();
  put("\nError:Processor fault: ");
  put(name_of(cause));
  put(", cause ");
  put_hexadecimal(cause);
  put(", pc ");
  put_hexadecimal(program_counter);
  put(", address ");
  put_hexadecimal(address);
  put(", sp ");
  put_hexadecimal(stack_pointer);
  put(", ra ");
  put_hexadecimal(return_address);
  put("\n");
  end();
}

void halt(const char* reason) {
  stop_everything();
  put("\nError:");
  put(reason);
  put("\n");
  end();
}

}  // namespace platform
