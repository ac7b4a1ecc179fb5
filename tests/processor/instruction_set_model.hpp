// SPDX-License-Identifier: Apache-2.0
// Model of RV32IMC, optionally with Zbb, and machine mode by the specification: one instruction
// at a time, untimed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/processor/instructions.hpp"
#include "tests/processor/test_device.hpp"

namespace processor {

// What one step did.
struct Step {
  bool trap = false;
  std::uint32_t address = 0;
  // As it lies in memory: of a compressed one the upper half is 0.
  std::uint32_t instruction = 0;
  unsigned destination = 0;
  std::uint32_t value = 0;
};

// Written from "The RISC-V Instruction Set Manual" (volume I 20240411, volume II 20240411) and not
// from the VHDL. Bus accesses go to a TestDevice of its own.
class InstructionSetModel {
 public:
  InstructionSetModel(std::vector<std::uint8_t> image, std::size_t memory_size,
                      bool has_zbb = false);

  // Executes the instruction at the program counter, or takes the exception that it raises.
  Step step();
  bool interrupt_due() const { return interrupt_enable_ && (device_.interrupts() & mie_) != 0; }
  // mstatus.MIE, and mie.
  bool interrupts_allowed() const { return interrupt_enable_; }
  std::uint32_t enabled_interrupts() const { return mie_; }
  // Takes the interrupt that is due instead; nothing where none is.
  std::optional<Step> take_interrupt();

  std::uint32_t program_counter() const { return program_counter_; }
  std::uint32_t reg(unsigned index) const { return registers_[index]; }
  const std::vector<std::uint8_t>& memory() const { return memory_; }
  // For the counter of clocks, which the model has not: takes over what the chip has read.
  void set_register(unsigned index, std::uint32_t value) { registers_[index] = value; }
  TestDevice& device() { return device_; }

 private:
  struct Exception {
    std::uint32_t cause;
    std::uint32_t value;
  };

  // `next`: the address after the instruction on entry, of the one to go on with on return.
  std::optional<Exception> execute(std::uint32_t instruction, std::uint32_t& next, Step& step);
  std::optional<Exception> execute_system(std::uint32_t instruction, std::uint32_t& next,
                                          Step& step);
  std::optional<Exception> load(std::uint32_t instruction, Step& step);
  std::optional<Exception> store(std::uint32_t instruction);
  void enter_trap(std::uint32_t cause, bool interrupt, std::uint32_t value);
  bool in_memory(std::uint32_t address) const;
  std::uint32_t word_at(std::uint32_t address) const;
  std::uint32_t half_word_at(std::uint32_t address) const;
  std::optional<Exception> fetch(Step& step) const;
  std::optional<std::uint32_t> read_csr(std::uint32_t address) const;
  void write_csr(std::uint32_t address, std::uint32_t value);
  void write_register(unsigned index, std::uint32_t value, Step& step);

  std::vector<std::uint8_t> memory_;
  bool has_zbb_;
  TestDevice device_;
  std::array<std::uint32_t, 32> registers_{};
  std::uint32_t program_counter_ = 0x80000000;
  bool interrupt_enable_ = false;
  bool previous_interrupt_enable_ = false;
  std::uint32_t mie_ = 0;
  std::uint32_t mtvec_ = 0;
  std::uint32_t mscratch_ = 0;
  std::uint32_t mepc_ = 0;
  std::uint32_t mcause_ = 0;
  std::uint32_t mtval_ = 0;
  std::uint32_t mcountinhibit_ = 0;
  std::uint64_t instret_ = 0;
  bool counter_written_ = false;
};

}  // namespace processor
