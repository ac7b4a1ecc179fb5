// SPDX-License-Identifier: Apache-2.0
// Each of the 4096 numbers of control and status registers, in every form of access: which
// registers there are, which of them refuse writes, and what cannot be changed. The table is the
// manual's (volume II 20240411, table 2), cut to what a processor with machine mode alone has.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>

#include "tests/processor/trial.hpp"

namespace processor {
namespace {

using encode::Word;

constexpr Word trap_vector = 0x305;

// What a register reads as at all times; nothing where that changes.
using Registers = std::map<Word, std::optional<Word>>;

Registers registers() {
  constexpr Word rv32imc = 0x40001104;
  Registers all{
      {0x300, {}}, {0x301, rv32imc}, {0x304, {}}, {trap_vector, {}},
      {0x310, 0},  // setup
      {0x320, {}},  // mcountinhibit
      {0x340, {}}, {0x341, {}},      {0x342, {}}, {0x343, {}},
      {0x344, 0},  // traps; nothing is requested
      {0x7A0, 0},  {0x7A1, 0},       {0x7A2, 0},  {0x7A3, 0},  // no trigger
      {0xB00, {}}, {0xB02, {}},      {0xB80, {}}, {0xB82, {}},  // clocks, instructions
      {0xC00, {}}, {0xC02, {}},      {0xC80, {}}, {0xC82, {}},  // ... as programs see them
      {0xF11, 0},  {0xF12, 0},       {0xF13, 0},  {0xF14, 0},
      {0xF15, 0},  // identity
  };
  for (Word counter = 3; counter < 32; ++counter) {
    for (const Word group : {0x320u, 0xB00u, 0xB80u}) all[group + counter] = 0;
  }
  return all;
}

struct Form {
  Word funct3;
  Word destination;
  Word source;  // a register, or with funct3 5 to 7 a number

  bool writes() const { return funct3 % 4 == 1 || source != 0; }
};

std::vector<Form> forms() {
  std::vector<Form> all;
  for (const Word funct3 : {1u, 2u, 3u, 5u, 6u, 7u}) {
    for (const Word destination : {0u, trial::destination}) {
      for (const Word source : {0u, funct3 < 4 ? trial::ones : 31u}) {
        all.push_back({funct3, destination, source});
      }
    }
  }
  return all;
}

// The numbers from `first` to `last` in every form: what each did, against the table.
void check(Word first, Word last) {
  const Registers table = registers();
  const auto all_forms = forms();
  std::vector<Word> instructions;
  for (Word number = first; number <= last; ++number) {
    if (number == trap_vector && first != last) continue;
    for (const Form& form : all_forms) {
      instructions.push_back(encode::csr(form.funct3, form.destination, number, form.source));
    }
  }
  const auto outcomes = try_instructions(instructions, 4);
  std::size_t traps = 0;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Outcome& outcome = outcomes[i];
    const Form& form = all_forms[i % all_forms.size()];
    const Word number = outcome.instruction >> 20;
    const bool only_read = number >> 10 == 3;
    const auto found = table.find(number);
    const bool legal = found != table.end() && !(only_read && form.writes());
    SCOPED_TRACE(testing::Message()
                 << std::hex << "CSR " << number << ", instruction " << outcome.instruction);
    ASSERT_EQ(outcome.trap.has_value(), !legal);
    if (!legal) {
      ASSERT_EQ(*outcome.trap, (TrapFindings{2, outcome.address, outcome.instruction}));
      ++traps;
    } else if (found->second && form.destination != 0) {
      ASSERT_EQ(outcome.value, *found->second);
    }
  }
  EXPECT_EQ(traps == 0, first == last);
}

TEST(CsrNumbers, exist_or_trap_in_every_form_of_access) { check(0x000, 0xFFF); }

// By itself, as the next trap would go where it points.
TEST(CsrNumbers, of_the_trap_vector_is_one_that_can_be_written) { check(trap_vector, trap_vector); }

// Each bit alone: written, set, cleared. What cannot be written stays as it is.
TEST(CsrNumbers, of_what_can_be_written_keep_each_bit_by_itself) {
  struct Register {
    Word number;
    Word writable;
    Word fixed;
  };
  constexpr Word all = 0xFFFFFFFF;
  // mstatus has two bits of its own and one mode; mtvec two ways; mepc half words; mcause 32 causes
  // of either kind; mie the interrupts that there are.
  constexpr std::array<Register, 11> registers{{{0x300, 0x88, 0x1800},
                                                {0x301, 0, 0x40001104},
                                                {0x304, 0xFFFF0880, 0},
                                                {trap_vector, all - 2, 0},
                                                {0x310, 0, 0},
                                                {0x320, 5, 0},
                                                {0x340, all, 0},
                                                {0x341, all - 1, 0},
                                                {0x342, 0x8000001F, 0},
                                                {0x343, all, 0},
                                                {0x344, 0, 0}}};
  constexpr Word write = 1, set = 2, clear = 3, bit_register = 7;
  std::vector<Word> instructions;
  const auto access = [&](Word funct3, Word number, Word source) {
    instructions.push_back(encode::csr(funct3, trial::destination, number, source));
  };
  for (const Register& reg : registers) {
    instructions.push_back(encode::add_immediate(bit_register, 0, 1));
    for (unsigned bit = 0; bit < 32; ++bit) {
      access(write, reg.number, bit_register);
      access(clear, reg.number, bit_register);  // finds it set
      access(set, reg.number, bit_register);  // finds it clear
      access(write, reg.number, trial::ones);  // finds it set
      access(clear, reg.number, bit_register);  // finds all set
      access(write, reg.number, 0);  // finds the others set
      instructions.push_back(encode::operation_immediate(1, bit_register, bit_register, 1));
    }
  }
  const auto outcomes = try_instructions(instructions, 4);
  auto outcome = outcomes.begin();
  for (const Register& reg : registers) {
    ++outcome;
    for (unsigned bit = 0; bit < 32; ++bit) {
      const Word one = Word{1} << bit & reg.writable, others = reg.writable & ~one;
      ++outcome;
      for (const Word found : {one, Word{0}, one, reg.writable, others}) {
        ASSERT_FALSE(outcome->trap) << std::hex << reg.number;
        ASSERT_EQ((outcome++)->value, found | reg.fixed)
            << std::hex << reg.number << " bit " << bit;
      }
      ++outcome;
    }
  }
}

}  // namespace
}  // namespace processor
