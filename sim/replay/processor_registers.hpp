// SPDX-License-Identifier: Apache-2.0
// The architectural registers of the processor in the netlist of the whole chip: the only file that
// knows their names.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/replay/snapshot.hpp"

namespace replay {

#define CPU(path) root.printer_core__DOT__with_processor_computing__DOT__cpu__DOT__##path
#define DECODE(name) CPU(decode__DOT__##name)
#define REGISTER_FILE(half) DECODE(operand_forwarding__DOT__register_file__DOT__##half)
#define CSR(name) CPU(machine_mode__DOT__control_status_registers__DOT__##name##_q)

inline constexpr std::size_t half_of_registers = 16;

template <class Root>
ProcessorSnapshot processor_registers(const Root& root) {
  ProcessorSnapshot snapshot;
  for (std::size_t i = 0; i < half_of_registers; ++i) {
    snapshot.registers[i] = REGISTER_FILE(lower)[i];
    snapshot.registers[i + half_of_registers] = REGISTER_FILE(upper)[i];
  }
  snapshot.program_counter = DECODE(executing_address_q);
  snapshot.mstatus = std::uint32_t{CSR(interrupt_enable)} << 3 |
                     std::uint32_t{CSR(previous_interrupt_enable)} << 7 | 3U << 11;
  snapshot.mie = CSR(enabled_interrupts);
  snapshot.mtvec = CSR(trap_base) << 2 | CSR(trap_vectored);
  snapshot.mscratch = CSR(scratch);
  snapshot.mepc = CSR(exception_address) << 1;
  snapshot.mcause = std::uint32_t{CSR(last_trap_was_interrupt)} << 31 | CSR(last_trap_cause);
  snapshot.mtval = CSR(last_trap_value);
  snapshot.mcountinhibit = std::uint32_t{CSR(instructions_stopped)} << 2 | CSR(cycle_stopped);
  snapshot.mcycle = CSR(cycle_counter__DOT__counted);
  snapshot.minstret = CSR(instruction_counter__DOT__counted);
  return snapshot;
}

// All except the program counter. Logic that depends on them is stale until the model is settled.
template <class Root>
void put_processor_registers(Root& root, const ProcessorSnapshot& snapshot) {
  for (std::size_t i = 0; i < half_of_registers; ++i) {
    REGISTER_FILE(lower)[i] = snapshot.registers[i];
    REGISTER_FILE(upper)[i] = snapshot.registers[i + half_of_registers];
  }
  CSR(interrupt_enable) = snapshot.mstatus >> 3 & 1;
  CSR(previous_interrupt_enable) = snapshot.mstatus >> 7 & 1;
  CSR(enabled_interrupts) = snapshot.mie;
  CSR(trap_base) = snapshot.mtvec >> 2;
  CSR(trap_vectored) = snapshot.mtvec & 1;
  CSR(scratch) = snapshot.mscratch;
  CSR(exception_address) = snapshot.mepc >> 1;
  CSR(last_trap_was_interrupt) = static_cast<std::uint8_t>(snapshot.mcause >> 31);
  CSR(last_trap_cause) = snapshot.mcause & 31;
  CSR(last_trap_value) = snapshot.mtval;
  CSR(instructions_stopped) = snapshot.mcountinhibit >> 2 & 1;
  CSR(cycle_stopped) = snapshot.mcountinhibit & 1;
  CSR(cycle_counter__DOT__counted) = snapshot.mcycle;
  CSR(instruction_counter__DOT__counted) = snapshot.minstret;
}

// Of a processor in reset: where it begins.
template <class Root>
void put_program_counter(Root& root, std::uint32_t address) {
  DECODE(alternate_address_q) = address;
}

#undef CSR
#undef REGISTER_FILE
#undef DECODE
#undef CPU

}  // namespace replay
