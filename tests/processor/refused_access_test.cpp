// SPDX-License-Identifier: Apache-2.0
// Every load and store at every place in a word, in the memory, at its ends, on the bus and where
// nothing is: which are refused, with which cause and address, and that a refused one does nothing.
#include <gtest/gtest.h>

#include <array>

#include "tests/processor/chip.hpp"
#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/trial.hpp"

namespace processor {
namespace {

using encode::Word;

constexpr Word base = 8;
constexpr Word word_access = 2;
constexpr Word memory_end = Chip::memory_base + Chip::memory_size;
// The start-up of what is tried lies at the beginning of the memory: its first words may
// be read only.
constexpr Word inside = 0x8000F004;

bool is_answered(Word address) {
  return (address >= Chip::memory_base && address < memory_end) ||
         address - TestDevice::base < 0x100;
}

// Addresses whose upper 20 bits lui sets; a store changes only where nothing else is.
struct Place {
  Word address;
  bool may_be_written;
};

constexpr std::array<Place, 8> places{{{inside, true},
                                       {Chip::memory_base, false},
                                       {memory_end - 4, true},
                                       {memory_end, true},
                                       {Chip::memory_base - 4, true},
                                       {TestDevice::base, true},
                                       {TestDevice::base + 0x200, true},
                                       {0, true}}};

std::optional<TrapFindings> expected_trap(const Outcome& outcome, Word address, Word bytes,
                                          bool stores) {
  if (address % bytes != 0) return TrapFindings{stores ? 6u : 4u, outcome.address, address};
  if (!is_answered(address)) return TrapFindings{stores ? 7u : 5u, outcome.address, address};
  return std::nullopt;
}

TEST(RefusedAccess, has_its_cause_and_address_for_every_width_and_place) {
  for (const Place& place : places) {
    for (const bool stores : {false, true}) {
      if (stores && !place.may_be_written) continue;
      for (const Word funct3 : {0u, 1u, 2u, 4u, 5u}) {
        if (stores && funct3 > word_access) continue;
        const Word bytes = 1u << funct3 % 4;
        for (Word in_word = 0; in_word < 4; ++in_word) {
          const Word address = place.address + in_word;
          const auto offset = static_cast<std::int32_t>(address << 20) >> 20;
          const Word upper = address - static_cast<Word>(offset);
          const auto outcomes =
              try_instructions({encode::load_upper(base, upper),
                                stores ? encode::store(funct3, trial::ones, base, offset)
                                       : encode::load(funct3, trial::destination, base, offset),
                                encode::load(word_access, trial::destination, base,
                                             offset - static_cast<std::int32_t>(in_word))},
                               4);
          const auto trap = expected_trap(outcomes[1], address, bytes, stores);
          ASSERT_EQ(outcomes[1].trap.has_value(), trap.has_value()) << std::hex << address;
          if (!trap) continue;
          ASSERT_EQ(*outcomes[1].trap, *trap) << std::hex << address << " width " << bytes;
          // The words that may be written hold 0.
          if (stores && !outcomes[2].trap) {
            ASSERT_EQ(outcomes[2].value, 0u) << std::hex << address;
          }
        }
      }
    }
  }
}

// The offsets of short instructions are multiples of 4, so the base decides; sp is a base
// of its own.
TEST(RefusedAccess, of_short_instructions_has_its_cause_and_address) {
  namespace compressed = encode::compressed;
  constexpr Word data = 9, stack_pointer = 2;
  constexpr std::int32_t offset = 12;
  for (Word in_word = 0; in_word < 4; ++in_word) {
    // 0x8000F000 and the place in the word, by short instructions alone.
    std::vector<Word> instructions{compressed::load_immediate(base, 1),
                                   compressed::shift_left(base, 31)};
    instructions.push_back(compressed::load_immediate(data, 15));
    instructions.push_back(compressed::shift_left(data, 12));
    instructions.push_back(compressed::add(base, data));
    instructions.push_back(compressed::add_immediate(base, static_cast<std::int32_t>(in_word)));
    instructions.push_back(compressed::move(stack_pointer, base));
    const std::size_t first = instructions.size();
    instructions.push_back(compressed::load(data, base, offset));
    instructions.push_back(compressed::store(data, base, offset));
    instructions.push_back(compressed::load_from_sp(data, offset));
    instructions.push_back(compressed::store_to_sp(data, offset));
    const auto outcomes = try_instructions(instructions, 2);
    for (std::size_t i = 0; i < 4; ++i) {
      const Outcome& outcome = outcomes[first + i];
      ASSERT_EQ(outcome.trap.has_value(), in_word != 0) << i;
      if (in_word == 0) continue;
      EXPECT_EQ(*outcome.trap, (TrapFindings{i % 2 == 0 ? 4u : 6u, outcome.address,
                                             0x8000F000 + in_word + offset}))
          << i;
    }
  }
}

}  // namespace
}  // namespace processor
