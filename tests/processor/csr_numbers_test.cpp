// SPDX-License-Identifier: Apache-2.0
// Each of the 4096 numbers of control and status registers, in every form of access: which
// registers there are, which of them refuse writes, and what cannot be changed. The table is the
// manual's (volume II 20240411, table 2), cut to what a processor with machine mode alone has.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace processor
