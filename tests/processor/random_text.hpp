// SPDX-License-Identifier: Apache-2.0
// What all random instructions are made with: choices, the registers that may be used, places to
// jump to.
#pragma once

#include <random>
#include <set>

#include "tests/processor/program_builder.hpp"
#include "tests/processor/random_program.hpp"

namespace processor {

// Registers with a fixed meaning; the rest is free for random results.
namespace random_registers {
inline constexpr encode::Word stack_pointer = 2, short_data_base = 8;
inline constexpr encode::Word handler = 26, handler_second = 27, jump_base = 28, tohost_base = 29;
inline constexpr encode::Word bus_base = 30, data_base = 31;
}  // namespace random_registers

namespace csr_numbers {
inline constexpr encode::Word mstatus = 0x300, mie = 0x304, mtvec = 0x305, mepc = 0x341,
                              mcause = 0x342, mtval = 0x343, mip = 0x344;
}  // namespace csr_numbers

// The program as far as it is chosen.
class RandomText {
 public:
  using Word = encode::Word;

  RandomText(std::uint32_t seed, const RandomProgramSettings& chosen)
      : settings(chosen), random_(seed) {}

  const RandomProgramSettings settings;
  ProgramBuilder program;

  void emit(Word instruction) { program.add(instruction); }

  Word any_word() { return static_cast<Word>(random_()); }
  Word below(Word limit) { return any_word() % limit; }
  bool one_in(Word count) { return below(count) == 0; }
  // Whether one of 1000 instructions that may be anything is due.
  bool wild() { return below(1000) < settings.wild_per_mille; }
  // One of those on which arithmetic turns, or any.
  Word interesting_value();

  Word source() { return below(random_registers::handler); }
  Word destination();
  // Registers that short instructions can name.
  Word short_source() { return 8 + below(8); }
  Word short_destination() { return 9 + below(7); }
  // Whether a word that may be anything is allowed to write there.
  static bool may_be_written(Word index);

  // A little ahead; no jump may lead between the instructions of a computed jump to there.
  std::size_t target_ahead();
  void add_target(std::size_t target) { targets_.insert(target); }
  bool is_target(std::size_t first, std::size_t last) const;

 private:
  std::mt19937 random_;
  std::set<std::size_t> targets_;
};

}  // namespace processor
