// SPDX-License-Identifier: Apache-2.0
// Every operation of two registers and of a register and a constant, on all pairs of the values at
// which arithmetic turns: the ends of the ranges, every single bit set and cleared, the usual
// patterns. Results are the host's, from the manual's sentences, not the model's.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

#include "tests/processor/trial.hpp"

namespace processor {
namespace {

using encode::Word;
using Wide = std::int64_t;

constexpr Word first_register = 7, second_register = 8;

std::int32_t number(Word word) { return static_cast<std::int32_t>(word); }
Wide wide(Word word) { return number(word); }
Word upper_half(Wide product) { return static_cast<Word>(product >> 32); }

// Quotients are rounded towards zero; by 0 the quotient is all ones and the remainder the dividend;
// the one quotient that does not fit is what it was.
Word quotient(Word a, Word b) { return b == 0 ? ~Word{0} : static_cast<Word>(wide(a) / wide(b)); }
Word remainder(Word a, Word b) { return b == 0 ? a : static_cast<Word>(wide(a) % wide(b)); }

struct Operation {
  std::string name;
  Word funct3;
  Word funct7;
  std::function<Word(Word, Word)> result;
};

const std::array operations{
    Operation{"add", 0, 0, [](Word a, Word b) { return a + b; }},
    Operation{"sub", 0, 0x20, [](Word a, Word b) { return a - b; }},
    Operation{"sll", 1, 0, [](Word a, Word b) { return a << (b & 31); }},
    Operation{"slt", 2, 0, [](Word a, Word b) { return Word{number(a) < number(b)}; }},
    Operation{"sltu", 3, 0, [](Word a, Word b) { return Word{a < b}; }},
    Operation{"xor", 4, 0, [](Word a, Word b) { return a ^ b; }},
    Operation{"srl", 5, 0, [](Word a, Word b) { return a >> (b & 31); }},
    Operation{"sra", 5, 0x20,
              [](Word a, Word b) { return static_cast<Word>(wide(a) >> (b & 31)); }},
    Operation{"or", 6, 0, [](Word a, Word b) { return a | b; }},
    Operation{"and", 7, 0, [](Word a, Word b) { return a & b; }},
    Operation{"mul", 0, 1, [](Word a, Word b) { return a * b; }},
    Operation{"mulh", 1, 1, [](Word a, Word b) { return upper_half(wide(a) * wide(b)); }},
    Operation{"mulhsu", 2, 1, [](Word a, Word b) { return upper_half(wide(a) * Wide{b}); }},
    Operation{"mulhu", 3, 1,
              [](Word a, Word b) { return static_cast<Word>(std::uint64_t{a} * b >> 32); }},
    Operation{"div", 4, 1, quotient},
    Operation{"divu", 5, 1, [](Word a, Word b) { return b == 0 ? ~Word{0} : a / b; }},
    Operation{"rem", 6, 1, remainder},
    Operation{"remu", 7, 1, [](Word a, Word b) { return b == 0 ? a : a % b; }},
};

std::vector<Word> corners() {
  std::vector<Word> values{0,          3,          5,          0x7FFFFFFE, 0x80000001,
                           0xFFFFFFFF, 0xFFFFFFFD, 0x55555555, 0xAAAAAAAA, 0x33333333,
                           0xCCCCCCCC, 0x0000FFFF, 0xFFFF0000, 46340,      46341};
  for (unsigned bit = 0; bit < 32; ++bit) {
    values.push_back(Word{1} << bit);
    values.push_back(~(Word{1} << bit));
  }
  return values;
}

// Instructions, and what those write whose result is of interest.
class Script {
 public:
  void set(Word index, Word value) {
    const Word rounded = value + 0x800;
    add(encode::load_upper(index, rounded));
    add(encode::add_immediate(index, index, number(value << 20) >> 20));
  }
  void expect(Word instruction, Word value, std::string what) {
    add(instruction);
    expectations_.push_back({instructions_.size() - 1, value, std::move(what)});
  }
  void check() const {
    const auto outcomes = try_instructions(instructions_, 4);
    for (const auto& [index, value, what] : expectations_) {
      ASSERT_FALSE(outcomes[index].trap) << what;
      ASSERT_EQ(outcomes[index].value, value) << std::hex << what;
    }
  }

 private:
  struct Expectation {
    std::size_t index;
    Word value;
    std::string what;
  };

  void add(Word instruction) { instructions_.push_back(instruction); }

  std::vector<Word> instructions_;
  std::vector<Expectation> expectations_;
};

std::string words(const std::string& name, Word first, Word second) {
  return name + " of " + std::to_string(first) + " and " + std::to_string(second);
}

TEST(Operations, of_two_registers_are_right_for_all_pairs_of_corners) {
  for (const Word first : corners()) {
    Script script;
    script.set(first_register, first);
    for (const Word second : corners()) {
      script.set(second_register, second);
      for (const Operation& operation : operations) {
        script.expect(encode::operation(operation.funct3, operation.funct7, trial::destination,
                                        first_register, second_register),
                      operation.result(first, second), words(operation.name, first, second));
      }
    }
    script.check();
    if (HasFailure()) break;
  }
}

TEST(Operations, of_a_register_and_a_constant_are_right_for_all_corners) {
  for (const Word first : corners()) {
    Script script;
    script.set(first_register, first);
    for (const Operation& operation : operations) {
      if (operation.funct7 == 1 || operation.name == "sub") continue;
      const bool shift = operation.funct3 % 4 == 1;
      for (const Word second : corners()) {
        const std::int32_t constant = number(second << 20) >> 20;
        const Word amount = second & 31;
        script.expect(
            encode::operation_immediate(
                operation.funct3, trial::destination, first_register,
                shift ? static_cast<std::int32_t>(operation.funct7 << 5 | amount) : constant),
            operation.result(first, shift ? amount : static_cast<Word>(constant)),
            words(operation.name + " with a constant", first, second));
      }
    }
    script.check();
    if (HasFailure()) break;
  }
}

}  // namespace
}  // namespace processor
