// SPDX-License-Identifier: Apache-2.0
// Machine mode in the instruction-set model: CSRs, traps, interrupts, returns.
#include <array>
#include <bit>

#include "tests/processor/instruction_set_model.hpp"

namespace processor {
namespace {

constexpr std::uint32_t interrupt_bits = TestDevice::interrupt_mask;

// In the order of rank: external, timer, then 16 to 31.
std::uint32_t first_interrupt(std::uint32_t active) {
  if ((active >> 11 & 1) != 0) return 11;
  if ((active >> 7 & 1) != 0) return 7;
  return static_cast<std::uint32_t>(std::countr_zero(active));
}

}  // namespace

void InstructionSetModel::enter_trap(std::uint32_t cause, bool interrupt, std::uint32_t value) {
  mepc_ = program_counter_;
  mcause_ = cause | (interrupt ? 1u << 31 : 0);
  mtval_ = value;
  previous_interrupt_enable_ = interrupt_enable_;
  interrupt_enable_ = false;
  program_counter_ = (mtvec_ & ~3u) + ((mtvec_ & 1) != 0 && interrupt ? 4 * cause : 0);
}

std::optional<Step> InstructionSetModel::take_interrupt() {
  if (!interrupt_due()) return std::nullopt;
  const std::uint32_t active = device_.interrupts() & mie_;
  const Step step{.trap = true, .address = program_counter_};
  enter_trap(first_interrupt(active), true, 0);
  return step;
}

std::optional<std::uint32_t> InstructionSetModel::read_csr(std::uint32_t address) const {
  switch (address) {
    case 0x300:
      return 0x1800u | (interrupt_enable_ ? 8u : 0) | (previous_interrupt_enable_ ? 0x80u : 0);
    case 0x301:
      return 1u << 30 | 1u << ('C' - 'A') | 1u << ('I' - 'A') | 1u << ('M' - 'A');
    case 0x304:
      return mie_;
    case 0x305:
      return mtvec_;
    case 0x320:
      return mcountinhibit_;
    case 0x340:
      return mscratch_;
    case 0x341:
      return mepc_;
    case 0x342:
      return mcause_;
    case 0x343:
      return mtval_;
    case 0x344:
      return device_.interrupts();
    case 0xB02:
    case 0xC02:
      return static_cast<std::uint32_t>(instret_);
    case 0xB82:
    case 0xC82:
      return static_cast<std::uint32_t>(instret_ >> 32);
    case 0xB00:
    case 0xC00:
    case 0xB80:
    case 0xC80:
    case 0x310:
    case 0x7A0:
    case 0x7A1:
    case 0x7A2:
    case 0x7A3:
    case 0xF11:
    case 0xF12:
    case 0xF13:
    case 0xF14:
    case 0xF15:
      return 0;
    default:
      break;
  }
  const bool event_counter = (address >= 0xB03 && address <= 0xB1F) ||
                             (address >= 0xB83 && address <= 0xB9F) ||
                             (address >= 0x323 && address <= 0x33F);
  return event_counter ? std::optional(0u) : std::nullopt;
}

void InstructionSetModel::write_csr(std::uint32_t address, std::uint32_t value) {
  switch (address) {
    case 0x300:
      interrupt_enable_ = (value & 8) != 0;
      previous_interrupt_enable_ = (value & 0x80) != 0;
      break;
    case 0x304:
      mie_ = value & interrupt_bits;
      break;
    case 0x305:
      mtvec_ = value & ~2u;
      break;
    case 0x320:
      mcountinhibit_ = value & 5;
      break;
    case 0x340:
      mscratch_ = value;
      break;
    case 0x341:
      mepc_ = value & ~1u;
      break;
    case 0x342:
      mcause_ = value & 0x8000001F;
      break;
    case 0x343:
      mtval_ = value;
      break;
    case 0xB02:
    case 0xB82: {
      const unsigned shift = address == 0xB82 ? 32 : 0;
      instret_ = (instret_ & ~(std::uint64_t{0xFFFFFFFF} << shift)) | std::uint64_t{value} << shift;
      counter_written_ = true;
      break;
    }
    default:
      break;
  }
}

std::optional<InstructionSetModel::Exception> InstructionSetModel::execute_system(
    std::uint32_t word, std::uint32_t& next, Step& step) {
  const Exception illegal{2, word};
  switch (word) {
    case 0x00000073:
      return Exception{11, 0};
    case 0x00100073:
      return Exception{3, program_counter_};
    case 0x10500073:
      return std::nullopt;
    case 0x30200073:
      next = mepc_;
      interrupt_enable_ = previous_interrupt_enable_;
      previous_interrupt_enable_ = true;
      return std::nullopt;
    default:
      break;
  }
  const unsigned funct3 = word >> 12 & 7, rd = word >> 7 & 31, rs1 = word >> 15 & 31;
  if (funct3 % 4 == 0) return illegal;
  const std::uint32_t address = word >> 20;
  const bool writes = funct3 % 4 == 1 || rs1 != 0;
  const auto old = read_csr(address);
  if (!old || (writes && address >> 10 == 3)) return illegal;
  const std::uint32_t operand = funct3 >= 4 ? rs1 : registers_[rs1];
  if (writes) {
    const std::array<std::uint32_t, 3> values{operand, *old | operand, *old & ~operand};
    write_csr(address, values[funct3 % 4 - 1]);
  }
  write_register(rd, *old, step);
  return std::nullopt;
}

}  // namespace processor
