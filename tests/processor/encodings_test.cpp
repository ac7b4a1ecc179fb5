// SPDX-License-Identifier: Apache-2.0
// Which words are instructions: every combination of opcode and function bits of the
// long words, every system instruction, every short word, against lists from the manual. What is
// none traps, with its bits and its address, and does nothing else.
#include <gtest/gtest.h>

#include "tests/processor/chip.hpp"
#include "tests/processor/trial.hpp"

namespace processor {
namespace {

using encode::Word;

constexpr Word load = 0x03, fence = 0x0F, immediate_operation = 0x13, upper_to_pc = 0x17,
               store = 0x23, operation = 0x33, upper = 0x37, branch = 0x63, jump_register = 0x67,
               jump = 0x6F, system = 0x73;

bool is_zbb_operation(Word funct7, Word funct3, Word second) {
  switch (funct7) {
    case 0x20:
      return funct3 == 4 || funct3 == 6 || funct3 == 7;
    case 0x05:
      return funct3 >= 4;
    case 0x30:
      return funct3 == 1 || funct3 == 5;
    case 0x04:
      return funct3 == 4 && second == 0;
    default:
      return false;
  }
}

bool is_zbb_immediate(Word funct7, Word funct3, Word second) {
  if (funct3 == 1) return funct7 == 0x30 && (second <= 2 || second == 4 || second == 5);
  return funct3 == 5 &&
         (funct7 == 0x30 || (funct7 == 0x14 && second == 7) || (funct7 == 0x34 && second == 24));
}

bool is_long_instruction(Word word) {
  const Word funct3 = word >> 12 & 7, funct7 = word >> 25, second = word >> 20 & 31;
  switch (word & 0x7F) {
    case upper:
    case upper_to_pc:
    case jump:
      return true;
    case jump_register:
      return funct3 == 0;
    case branch:
      return funct3 != 2 && funct3 != 3;
    case load:
      return funct3 <= 2 || funct3 == 4 || funct3 == 5;
    case store:
      return funct3 <= 2;
    case fence:
      return funct3 <= 1;
    case immediate_operation:
      if (Chip::has_zbb && is_zbb_immediate(funct7, funct3, second)) return true;
      return funct3 % 4 != 1 || funct7 == 0 || (funct3 == 5 && funct7 == 0x20);
    case operation:
      if (Chip::has_zbb && is_zbb_operation(funct7, funct3, second)) return true;
      return funct7 <= 1 || (funct7 == 0x20 && (funct3 == 0 || funct3 == 5));
    default:
      return false;
  }
}

bool is_jump(Word word) {
  const Word opcode = word & 0x7F;
  return opcode == jump || opcode == jump_register || opcode == branch;
}

// The reserved ones of the chapter on extension C, and those of floating point and of 64 bits.
bool is_short_instruction(Word half_word) {
  const Word funct3 = half_word >> 13, bit_12 = half_word >> 12 & 1, rd = half_word >> 7 & 31,
             rs2 = half_word >> 2 & 31;
  switch ((half_word & 3) << 3 | funct3) {
    case 000:  // c.addi4spn
      return (half_word >> 5 & 0xFF) != 0;
    case 002:
    case 006:  // c.lw, c.sw
      return true;
    case 010:
    case 011:
    case 012:
    case 015:
    case 016:
    case 017:  // c.addi, c.jal, c.li, c.j, c.beqz, c.bnez
      return true;
    case 013:  // c.lui, c.addi16sp
      return bit_12 != 0 || rs2 != 0;
    case 014:  // c.andi; shifts by less than 32; operations of 32 bits
      return (half_word >> 10 & 3) == 2 || bit_12 == 0;
    case 020:  // c.slli
      return bit_12 == 0;
    case 022:  // c.lwsp
      return rd != 0;
    case 024:  // c.jr, c.mv, c.ebreak, c.jalr, c.add
      return rs2 != 0 || rd != 0 || bit_12 != 0;
    case 026:  // c.swsp
      return true;
    default:
      return false;
  }
}

void expect_refused(const Outcome& outcome) {
  ASSERT_TRUE(outcome.trap) << std::hex << outcome.instruction << " is no instruction";
  ASSERT_EQ(*outcome.trap, (TrapFindings{2, outcome.address, outcome.instruction}))
      << std::hex << outcome.instruction;
}

// How many were refused.
std::size_t check_long(const std::vector<Word>& words) {
  std::size_t refused = 0;
  for (const Outcome& outcome : try_instructions(words, 4)) {
    if (is_long_instruction(outcome.instruction)) {
      EXPECT_FALSE(outcome.trap) << std::hex << outcome.instruction << " is an instruction";
    } else {
      expect_refused(outcome);
      ++refused;
    }
    if (testing::Test::HasFailure()) break;
  }
  return refused;
}

TEST(Encodings, of_opcode_and_function_are_instructions_or_trap) {
  std::vector<Word> words;
  for (Word opcode = 3; opcode < 0x80; opcode += 4) {
    if (opcode == system) continue;
    // The upper bits of an offset, too; its lower ones are 0, so nothing is misaligned.
    const Word destination = opcode == store ? 0 : trial::destination;
    for (Word functions = 0; functions < 8 * 128; ++functions) {
      const Word word =
          encode::register_type(opcode, functions % 8, functions / 8, destination, trial::base, 0);
      if (!(is_jump(word) && is_long_instruction(word))) words.push_back(word);
    }
  }
  EXPECT_GT(check_long(words), words.size() / 2);
}

TEST(Encodings, of_operations_are_instructions_or_trap_with_every_second_register) {
  std::vector<Word> words;
  for (const Word opcode : {operation, immediate_operation}) {
    for (Word bits = 0; bits < 8 * 4096; ++bits) {
      words.push_back(encode::register_type(opcode, bits % 8, bits >> 8, trial::destination,
                                            trial::base, bits >> 3 & 31));
    }
  }
  EXPECT_GT(check_long(words), words.size() / 2);
}

TEST(Encodings, of_the_system_are_four_and_all_others_trap) {
  constexpr Word call = 0x000, breakpoint = 0x001, trap_return = 0x302, wait = 0x105;
  std::vector<Word> words;
  for (Word number = 0; number < 4096; ++number) {
    if (number != trap_return && number != wait) words.push_back(encode::csr(0, 0, number, 0));
    // With registers they are none; and 4 is a function of hypervisors.
    words.push_back(encode::csr(0, 1, number, 0));
    words.push_back(encode::csr(0, 0, number, 1));
    words.push_back(encode::csr(4, 0, number, 0));
  }
  for (const Outcome& outcome : try_instructions(words, 4)) {
    if (outcome.instruction == encode::csr(0, 0, call, 0)) {
      EXPECT_EQ(outcome.trap, (TrapFindings{11, outcome.address, 0}));
    } else if (outcome.instruction == encode::csr(0, 0, breakpoint, 0)) {
      EXPECT_EQ(outcome.trap, (TrapFindings{3, outcome.address, outcome.address}));
    } else {
      expect_refused(outcome);
    }
    if (HasFailure()) break;
  }
}

TEST(Encodings, of_short_words_that_are_reserved_trap) {
  std::vector<Word> reserved;
  std::vector<Word> instructions;
  for (Word half_word = 0; half_word < 0x10000; ++half_word) {
    if ((half_word & 3) == 3) continue;
    (is_short_instruction(half_word) ? instructions : reserved).push_back(half_word);
  }
  // What neither jumps nor loads nor stores, nor writes what the program needs: c.addi4spn, c.andi,
  // shifts and operations, all on x8 to x15.
  std::erase_if(instructions, [](Word half_word) {
    const Word kind = (half_word & 3) << 3 | half_word >> 13;
    return kind != 000 && kind != 014;
  });
  for (const Outcome& outcome : try_instructions(reserved, 2)) {
    expect_refused(outcome);
    if (HasFailure()) return;
  }
  for (const Outcome& outcome : try_instructions(instructions, 2)) {
    ASSERT_FALSE(outcome.trap) << std::hex << outcome.instruction << " is an instruction";
  }
}

}  // namespace
}  // namespace processor
