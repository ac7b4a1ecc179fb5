// SPDX-License-Identifier: Apache-2.0
// The control and status registers.
#include <algorithm>
#include <array>

#include "sim/processor/processor_model.hpp"

namespace processor {

namespace {

enum Number : std::uint32_t {
  mstatus = 0x300,
  misa = 0x301,
  mie = 0x304,
  mtvec = 0x305,
  mstatush = 0x310,
  mcountinhibit = 0x320,
  mscratch = 0x340,
  mepc = 0x341,
  mcause = 0x342,
  mtval = 0x343,
  mip = 0x344,
  tselect = 0x7a0,
  tdata3 = 0x7a3,
  mcycle = 0xb00,
  minstret = 0xb02,
  mcycleh = 0xb80,
  minstreth = 0xb82,
  cycle = 0xc00,
  instret = 0xc02,
  cycleh = 0xc80,
  instreth = 0xc82,
  mvendorid = 0xf11,
  mconfigptr = 0xf15,
};

constexpr std::uint32_t interrupt_bits = 0xffff'0880;
constexpr std::uint32_t mie_bit = 1U << 3, mpie_bit = 1U << 7, mpp_bits = 3U << 11;
constexpr std::uint32_t cycle_stopped = 1, instret_stopped = 4;
// RV32, I, M and C.
constexpr std::uint32_t extensions = 1U << 30 | 1U << 12 | 1U << 8 | 1U << 2;

bool is_between(std::uint32_t number, std::uint32_t first, std::uint32_t last) {
  return number >= first && number <= last;
}

// Read-only zero.
bool is_zero(std::uint32_t number) {
  return number == mstatush || is_between(number, tselect, tdata3) ||
         is_between(number, mvendorid, mconfigptr) || is_between(number, 0xb03, 0xb1f) ||
         is_between(number, 0xb83, 0xb9f) || is_between(number, 0x323, 0x33f);
}

std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }
std::uint32_t high(std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); }

std::uint64_t with_half(std::uint64_t old, bool upper, std::uint32_t value) {
  const std::uint64_t half = 0xffff'ffff;
  return upper ? (old & half) | std::uint64_t{value} << 32 : (old & ~half) | value;
}

}  // namespace

bool ProcessorModel::read_csr(std::uint32_t number, Clock clock, std::uint32_t& value) const {
  const MachineState& s = state_;
  switch (number) {
    case mstatus:
      value = mpp_bits | (s.interrupt_enable ? mie_bit : 0) |
              (s.previous_interrupt_enable ? mpie_bit : 0);
      return true;
    case misa:
      value = extensions;
      return true;
    case mie:
      value = s.interrupts_enabled;
      return true;
    case mtvec:
      value = s.trap_vector;
      return true;
    case mcountinhibit:
      value = (s.cycles.stopped ? cycle_stopped : 0) | (s.retired.stopped ? instret_stopped : 0);
      return true;
    case mscratch:
      value = s.scratch;
      return true;
    case mepc:
      value = s.exception_address;
      return true;
    case mcause:
      value = s.trap_cause;
      return true;
    case mtval:
      value = s.trap_value;
      return true;
    case mip:
      value = s.lines;
      return true;
    case mcycle:
    case cycle:
      value = low(s.cycles.at(clock));
      return true;
    case mcycleh:
    case cycleh:
      value = high(s.cycles.at(clock));
      return true;
    case minstret:
    case instret:
      value = low(s.retired.at(s.instructions));
      return true;
    case minstreth:
    case instreth:
      value = high(s.retired.at(s.instructions));
      return true;
    default:
      value = 0;
      return is_zero(number);
  }
}

// In `clock`; `instructions` does not count this one yet.
void ProcessorModel::write_csr(std::uint32_t number, std::uint32_t value, Clock clock) {
  MachineState& s = state_;
  const Clock next_clock = clock + 1;
  const std::uint64_t next_instruction = s.instructions + 1;
  switch (number) {
    case mstatus:
      s.interrupt_enable = (value & mie_bit) != 0;
      s.previous_interrupt_enable = (value & mpie_bit) != 0;
      break;
    case mie:
      s.interrupts_enabled = value & interrupt_bits;
      break;
    case mtvec:
      s.trap_vector = value & ~2U;
      break;
    case mcountinhibit:
      // This clock and this instruction count as before.
      s.cycles.set(next_clock, s.cycles.at(next_clock));
      s.retired.set(next_instruction, s.retired.at(next_instruction));
      s.cycles.stopped = (value & cycle_stopped) != 0;
      s.retired.stopped = (value & instret_stopped) != 0;
      break;
    case mscratch:
      s.scratch = value;
      break;
    case mepc:
      s.exception_address = value & ~1U;
      break;
    case mcause:
      s.trap_cause = value & (1U << 31 | 31);
      break;
    case mtval:
      s.trap_value = value;
      break;
    case mcycle:
    case mcycleh:
      // The other half goes on counting.
      s.cycles.set(next_clock, with_half(s.cycles.at(next_clock), number == mcycleh, value));
      break;
    case minstret:
    case minstreth:
      // This instruction does not count.
      s.retired.set(next_instruction,
                    with_half(s.retired.at(s.instructions), number == minstreth, value));
      break;
    default:
      break;
  }
}

ProcessorModel::CsrResult ProcessorModel::execute_csr(const Instruction& instruction, Clock clock) {
  const std::uint32_t number = instruction.immediate;
  const unsigned funct3 = instruction.word >> 12 & 7;
  const std::uint32_t field = instruction.word >> 15 & 31;
  const bool writes = funct3 % 4 == 1 || field != 0;
  if (number == mip) {
    if (clock > lines_known_) return CsrResult::too_early;
    sensitive_ = true;
  }
  std::uint32_t old = 0;
  constexpr std::uint32_t read_only = 3;  // both upper bits of the number
  if (!read_csr(number, clock, old) || (writes && number >> 10 == read_only)) {
    return CsrResult::illegal;
  }
  const std::uint32_t operand = funct3 >= 4 ? field : state_.registers[instruction.first];
  if (writes) {
    const std::array<std::uint32_t, 3> values{operand, old | operand, old & ~operand};
    write_csr(number, values[funct3 % 4 - 1], clock);
    // What is pending is seen with the new mie and mstatus.
    state_.open_from = std::max(state_.open_from, clock + 1);
  }
  state_.registers[instruction.destination] = old;
  ++state_.instructions;
  state_.program_counter += instruction.bytes;
  state_.begins = clock + 1;
  state_.late_register = instruction.destination;
  return CsrResult::done;
}

}  // namespace processor
