// SPDX-License-Identifier: Apache-2.0
// Programs of random instructions.
#include "tests/processor/random_program.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <utility>

#include "tests/processor/encode.hpp"
#include "tests/processor/test_device.hpp"

namespace processor {
namespace {

using encode::Word;

// Registers with a fixed meaning; the rest is free for random results.
constexpr Word handler_register = 26, handler_second = 27, jump_base = 28, tohost_base = 29;
constexpr Word bus_base = 30, data_base = 31;
constexpr Word data_address = 0x8000C000;
constexpr Word mstatus = 0x300, mie = 0x304, mtvec = 0x305, mepc = 0x341, mcause = 0x342;
constexpr Word words_of_prologue = 64;

class Generator {
 public:
  Generator(std::uint32_t seed, const RandomProgramSettings& settings)
      : random_(seed), settings_(settings) {}

  std::vector<Word> generate() {
    prologue();
    while (program_.size() < words_of_prologue + settings_.length) add_instruction();
    // Jumps may lead a little beyond the end.
    for (int count = 0; count < 40; ++count) emit(encode::nop());
    emit(encode::add_immediate(1, 0, 1));
    emit(encode::store(2, 1, tohost_base, 0));
    emit(encode::jump_and_link(0, 0));
    return program_;
  }

 private:
  Word below(Word limit) { return static_cast<Word>(random_() % limit); }
  bool one_in(Word count) { return below(count) == 0; }
  void emit(Word word) { program_.push_back(word); }
  Word source() { return below(26); }
  Word destination() { return below(26); }
  std::int32_t small_immediate() { return static_cast<std::int32_t>(below(4096)) - 2048; }

  void load_constant(Word rd, Word value) {
    emit(encode::load_upper(rd, value + 0x800));
    emit(encode::add_immediate(rd, rd, static_cast<std::int32_t>(value << 20) >> 20));
  }

  // Interrupts: the device is made quiet. Exceptions: the instruction is skipped.
  void prologue() {
    constexpr Word handler_words = 11;
    emit(encode::jump_and_link(0, 4 * (handler_words + 1)));
    emit(encode::csr(2, handler_register, mcause, 0));
    emit(encode::branch(5, handler_register, 0, 20));
    emit(encode::store(2, 0, bus_base, 0x100));
    emit(encode::csr(2, handler_second, 0x344, 0));
    emit(encode::branch(1, handler_second, 0, -8));
    emit(encode::jump_and_link(0, 16));
    emit(encode::csr(2, handler_register, mepc, 0));
    emit(encode::add_immediate(handler_register, handler_register, 4));
    emit(encode::csr(1, 0, mepc, handler_register));
    emit(encode::csr(2, 0, 0x343, 0));
    emit(encode::trap_return());
    load_constant(handler_register, 0x80000004);
    emit(encode::csr(1, 0, mtvec, handler_register));
    load_constant(tohost_base, random_program_tohost);
    load_constant(bus_base, TestDevice::base);
    load_constant(data_base, data_address);
    while (program_.size() < words_of_prologue - 20) emit(encode::nop());
    for (Word index = 1; index <= 10; ++index) load_constant(index, interesting_value());
  }

  Word interesting_value() {
    constexpr std::array<Word, 8> values{0,          1,          0xFFFFFFFF, 0x80000000,
                                         0x7FFFFFFF, 0x55555555, 0xFFFF,     2};
    return one_in(2) ? values[below(values.size())] : static_cast<Word>(random_());
  }

  void add_instruction() {
    if (below(1000) < settings_.wild_per_mille) return emit(wild_word());
    switch (below(settings_.interrupts ? 22 : 20)) {
      case 0:
      case 1:
      case 2:
      case 3:
        return add_operation();
      case 4:
      case 5:
      case 6:
        return add_immediate_operation();
      case 7:
        return emit(one_in(2) ? encode::load_upper(destination(), interesting_value())
                              : encode::add_upper_to_pc(destination(), interesting_value()));
      case 8:
      case 9:
      case 10:
        return emit(encode::operation(below(8), 1, destination(), source(), source()));
      case 11:
      case 12:
      case 13:
        return add_load();
      case 14:
      case 15:
        return add_store();
      case 16:
      case 17:
        return add_branch();
      case 18:
        return add_jump();
      default:
        return add_system();
    }
  }

  void add_operation() {
    const Word funct3 = below(8);
    const bool alternate = (funct3 == 0 || funct3 == 5) && one_in(2);
    emit(encode::operation(funct3, alternate ? 0x20 : 0, destination(), source(), source()));
  }

  void add_immediate_operation() {
    const Word funct3 = below(8);
    std::int32_t immediate = small_immediate();
    if (funct3 == 1) immediate &= 31;
    if (funct3 == 5) immediate &= 0x41F;
    emit(encode::operation_immediate(funct3, destination(), source(), immediate));
  }

  // Mostly a place in memory, sometimes on the bus, rarely misaligned or where nothing answers.
  std::pair<Word, std::int32_t> place(Word size) {
    std::int32_t offset = static_cast<std::int32_t>(below(256)) - 128;
    if (!one_in(12)) offset &= -static_cast<std::int32_t>(1u << size);
    if (!one_in(6)) return {data_base, offset};
    return {bus_base, one_in(5) ? offset + 0x400 : (offset & 0xFF)};
  }

  void add_load() {
    constexpr std::array<Word, 5> kinds{0, 1, 2, 4, 5};
    const Word funct3 = kinds[below(kinds.size())];
    const auto [base, offset] = place(funct3 & 3);
    emit(encode::load(funct3, destination(), base, offset));
  }

  void add_store() {
    const Word funct3 = below(3);
    const auto [base, offset] = place(funct3);
    emit(encode::store(funct3, source(), base, offset));
  }

  void add_branch() {
    constexpr std::array<Word, 6> kinds{0, 1, 4, 5, 6, 7};
    std::int32_t offset = 4 * static_cast<std::int32_t>(1 + below(8));
    targets_.insert(program_.size() + static_cast<std::size_t>(offset / 4));
    if (one_in(20)) offset += 2;
    emit(encode::branch(kinds[below(kinds.size())], source(), source(), offset));
  }

  void add_jump() {
    const std::int32_t misalignment = one_in(20) ? 2 : 0;
    const auto words = static_cast<std::int32_t>(2 + below(6));
    targets_.insert(program_.size() + static_cast<std::size_t>(words));
    // Nobody may jump between the two instructions of a computed jump: it would go back.
    if (one_in(2) || targets_.contains(program_.size() + 1)) {
      return emit(encode::jump_and_link(destination(), 4 * words + misalignment));
    }
    emit(encode::add_upper_to_pc(jump_base, 0));
    const std::int32_t odd = one_in(4) ? 1 : 0;
    emit(encode::jump_and_link_register(one_in(3) ? jump_base : destination(), jump_base,
                                        4 * words + misalignment + odd));
  }

  void add_system() {
    switch (below(settings_.interrupts ? 9 : 6)) {
      case 0:
        return emit(encode::environment_call());
      case 1:
        return emit(encode::breakpoint());
      case 2:
        return emit(one_in(2) ? encode::fence() : encode::fence_i());
      case 3:
      case 4:
      case 5:
        return add_csr();
      case 6:
        return emit(encode::store(2, source(), bus_base, 0x100));
      case 7:
        return emit(encode::csr(one_in(4) ? 1 : 2, destination(), mie, source()));
      default:
        return emit(encode::csr(one_in(4) ? 7 : 6, destination(), mstatus, 8));
    }
  }

  void add_csr() {
    constexpr std::array<Word, 24> addresses{
        0x300, 0x301, 0x310, 0x320, 0x340, 0x340, 0x340, 0x341, 0x342, 0x343, 0x344, 0x7A0,
        0xB00, 0xB02, 0xB82, 0xB03, 0x323, 0xC00, 0xC02, 0xC82, 0xF11, 0xF14, 0x180, 0x3A0};
    const Word kind = 1 + below(3);
    const Word address = one_in(10) ? below(4096) : addresses[below(addresses.size())];
    // The handler must stay where it is; interrupts are switched on only where they are wanted.
    const bool keep =
        address == mtvec || (!settings_.interrupts && (address == mie || address == mstatus));
    if (keep) return emit(encode::csr(2, destination(), address, 0));
    emit(encode::csr(one_in(3) ? kind + 4 : kind, destination(), address, source()));
  }

  Word wild_word() {
    while (true) {
      auto word = static_cast<Word>(random_());
      if (!one_in(4)) word |= 3;
      const Word opcode = word & 0x7F, rd = word >> 7 & 31;
      const bool moves = opcode == 0x6F || opcode == 0x67 || opcode == 0x63 || opcode == 0x23;
      const bool system =
          opcode == 0x73 &&
          (word >> 20 == mtvec || word == encode::wait_for_interrupt() ||
           word == encode::trap_return() || word >> 20 == mie || word >> 20 == mstatus);
      if (!moves && !system && rd < 26) return word;
    }
  }

  std::mt19937 random_;
  RandomProgramSettings settings_;
  std::vector<Word> program_;
  std::set<std::size_t> targets_;
};

}  // namespace

std::vector<std::uint8_t> random_program(std::uint32_t seed,
                                         const RandomProgramSettings& settings) {
  std::vector<std::uint8_t> bytes;
  for (const Word word : Generator(seed, settings).generate()) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      bytes.push_back(static_cast<std::uint8_t>(word >> shift));
    }
  }
  return bytes;
}

}  // namespace processor
