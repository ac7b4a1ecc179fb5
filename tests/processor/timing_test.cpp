// SPDX-License-Identifier: Apache-2.0
// Every instruction takes the clocks that the table in rtl/processor/timing.md says, after every
// other and at both places in a word.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/processor/timing_table.hpp"
#include "tests/processor/chip.hpp"
#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/timing_kinds.hpp"

namespace processor {
namespace {

using encode::Word;
using namespace timed;
namespace compressed = encode::compressed;

const std::vector<Kind>& kinds = kinds_of_instructions();

std::uint64_t clock_at(Chip& chip, Word address) {
  while (const auto event = chip.next_retirement()) {
    if (!event->trap && event->address == address) return event->clock;
  }
  return 0;
}

// Clocks of the instructions together; the last one may be a jump to the address after it.
unsigned measure_at(const std::vector<Word>& tested, bool in_the_middle) {
  const Placed placed = place(tested, in_the_middle);
  Chip chip(placed.image);
  const std::uint64_t before = clock_at(chip, placed.before);
  const std::uint64_t after = clock_at(chip, placed.next);
  return static_cast<unsigned>(after - before - 1);
}

// The same, which is the same at both places.
unsigned measure(const std::vector<Word>& tested) {
  const unsigned clocks = measure_at(tested, false);
  EXPECT_EQ(measure_at(tested, true), clocks) << "in the middle of a word";
  return clocks;
}

bool traps(const Kind& kind) {
  return kind.row == std::string("exception") || kind.row == std::string("refused access");
}

// Handlers are word-aligned: so is the instruction after the trap.
unsigned measure_trap(Word instruction) {
  return measure_at({instruction}, (instruction & 3) != 3);
}

TEST(Timing, each_instruction_takes_its_clocks) {
  const TimingTable table;
  for (const auto& kind : kinds) {
    EXPECT_EQ(traps(kind) ? measure_trap(kind.word) : measure({kind.word}), table.at(kind.row))
        << kind.row << std::hex << " " << kind.word;
  }
}

TEST(Timing, an_instruction_behind_another_takes_its_own_clocks) {
  const TimingTable table;
  for (const auto& first : kinds) {
    if (first.placed) continue;
    for (const auto& second : kinds) {
      if (traps(second)) continue;
      EXPECT_EQ(measure({first.word, second.word}), table.at(first.row) + table.at(second.row))
          << first.row << ", " << second.row << std::hex << " " << first.word << " " << second.word;
    }
  }
}

TEST(Timing, a_branch_backwards_takes_its_clocks_where_it_is_taken) {
  const TimingTable table;
  const unsigned jumps = 2 * table.at("jump");
  const unsigned wanted = jumps + table.at("branch predicted taken, taken");
  // Over a jump to the end, then back to it.
  EXPECT_EQ(measure({encode::jump_and_link(0, 8), encode::jump_and_link(0, 8),
                     encode::branch(0, 0, 0, -4)}),
            jumps + table.at("branch predicted not taken, taken"));
  EXPECT_EQ(measure({encode::jump_and_link(0, 8), encode::jump_and_link(0, 8),
                     encode::branch(1, 3, 4, -4)}),
            wanted);
  EXPECT_EQ(measure({encode::jump_and_link(0, 8), encode::jump_and_link(0, 8),
                     encode::branch(5, 3, 4, -4)}),
            wanted);
  EXPECT_EQ(measure({encode::jump_and_link(0, 8), encode::jump_and_link(0, 6),
                     compressed::branch(true, short_data_base, -4)}),
            wanted);
}

TEST(Timing, only_the_next_instruction_waits_for_a_late_result) {
  const TimingTable table;
  const unsigned wait = table.at("load-use hazard");
  const unsigned one = table.at("arithmetic and logic");
  const std::vector<Word> readers{encode::operation(0, 0, 1, late_result, 3),
                                  encode::operation(0, 0, 1, 3, late_result),
                                  encode::add_immediate(late_result, late_result, 1),
                                  encode::store(2, late_result, data_base, 0),
                                  encode::branch(1, late_result, late_result, 4),
                                  encode::operation(1, 1, 1, late_result, 3),
                                  compressed::add(1, late_result),
                                  compressed::add_immediate(late_result, 1),
                                  compressed::short_operation(2, 9, late_result),
                                  compressed::move(1, late_result),
                                  compressed::store_to_sp(late_result, 4),
                                  compressed::store(late_result, short_data_base, 4)};
  for (const auto& kind : kinds) {
    if (kind.placed) continue;
    for (const Word reader : readers) {
      EXPECT_EQ(measure({kind.word, reader}), table.at(kind.row) + one + (kind.late ? wait : 0))
          << kind.row;
      EXPECT_EQ(measure({kind.word, encode::nop(), reader}), table.at(kind.row) + 2 * one)
          << kind.row;
    }
    // The same bits in an immediate cause no hazard.
    EXPECT_EQ(measure({kind.word, encode::load_upper(1, late_result << 15 | late_result << 20)}),
              table.at(kind.row) + one);
    EXPECT_EQ(measure({kind.word, encode::csr(6, 1, 0x340, late_result)}),
              table.at(kind.row) + table.at("CSR instruction"));
    EXPECT_EQ(measure({kind.word, encode::add_immediate(1, 3, late_result)}),
              table.at(kind.row) + one);
    EXPECT_EQ(measure({kind.word, compressed::load_immediate(late_result, late_result)}),
              table.at(kind.row) + one);
  }
}

TEST(Timing, values_do_not_matter) {
  const TimingTable table;
  for (const Word funct3 : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u}) {
    for (const Word first : {0u, 4u, 3u, 30u, 31u}) {
      for (const Word second : {0u, 4u, 3u, 30u, 31u}) {
        EXPECT_EQ(measure({encode::operation(funct3, 1, 1, first, second)}),
                  table.at(funct3 < 4 ? "multiplication" : "division"));
      }
    }
  }
}

}  // namespace
}  // namespace processor
