// SPDX-License-Identifier: Apache-2.0
// Every instruction takes the clocks that the table in rtl/processor/README.md says, behind every
// other and at both places in a word.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/processor/chip.hpp"
#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/program_builder.hpp"

namespace processor {
namespace {

using encode::Word;
namespace compressed = encode::compressed;

constexpr Word data_base = 31, bus_base = 30, late_result = 15, place_address = 28;
constexpr Word short_data_base = 8, stack_pointer = 2;
constexpr Word program_bytes = 256;

// The rows `| name | clocks |` of the table.
std::map<std::string, unsigned> read_table() {
  std::ifstream file(PROJECT_DIRECTORY "/rtl/processor/README.md");
  std::map<std::string, unsigned> table;
  const std::regex row(R"(\| ([^|]+) \| (\d+) \|.*)");
  std::string line;
  std::smatch match;
  while (std::getline(file, line)) {
    if (std::regex_match(line, match, row))
      table[match[1]] = static_cast<unsigned>(std::stoul(match[2]));
  }
  return table;
}

// An instruction that goes on with the next, whatever it is. `late_result` is what it writes.
struct Kind {
  const char* row;
  Word word;
  bool late = false;
  // It reads mepc, mtvec or place_address as the next instruction's address.
  bool placed = false;
};

const std::vector<Kind> kinds_of_all{
    {"arithmetic and logic", encode::add_immediate(1, 4, 3)},
    {"arithmetic and logic", encode::operation(5, 0x20, 1, 4, 3)},
    {"arithmetic and logic", encode::load_upper(1, 0x12345000)},
    {"arithmetic and logic", encode::add_upper_to_pc(1, 0x1000)},
    {"arithmetic and logic", encode::fence()},
    {"multiplication", encode::operation(0, 1, late_result, 4, 3), true},
    {"multiplication", encode::operation(1, 1, late_result, 4, 3), true},
    {"multiplication", encode::operation(2, 1, late_result, 4, 3), true},
    {"multiplication", encode::operation(3, 1, late_result, 4, 3), true},
    {"division", encode::operation(4, 1, late_result, 4, 3)},
    {"division", encode::operation(5, 1, late_result, 3, 4)},
    {"division", encode::operation(6, 1, late_result, 4, 0)},
    {"division", encode::operation(7, 1, late_result, 0, 0)},
    {"load from memory", encode::load(0, late_result, data_base, 3), true},
    {"load from memory", encode::load(1, late_result, data_base, 2), true},
    {"load from memory", encode::load(2, late_result, data_base, 4), true},
    {"load from memory", encode::load(5, late_result, data_base, 8), true},
    {"store to memory", encode::store(0, 4, data_base, 1)},
    {"store to memory", encode::store(2, 4, data_base, 4)},
    {"load from a peripheral", encode::load(2, late_result, bus_base, 4), true},
    {"store to a peripheral", encode::store(2, 4, bus_base, 8)},
    {"other branch, not taken", encode::branch(1, 0, 0, 4)},
    {"other branch, not taken", encode::branch(4, 4, 4, 4)},
    {"branch taken early, not taken", encode::branch(1, 0, 0, -4)},
    {"branch taken early, not taken", encode::branch(7, 3, 4, -8)},
    {"branch taken early, not taken", encode::branch(5, 4, 3, -8)},
    {"other branch, not taken", encode::branch(4, 4, 4, -8)},
    {"other branch, not taken", encode::branch(0, 3, 4, -4)},
    {"other branch, taken", encode::branch(0, 0, 0, 4)},
    {"other branch, taken", encode::branch(7, 4, 4, 4)},
    {"jump", encode::jump_and_link(1, 4)},
    {"fence.i", encode::fence_i()},
    {"CSR instruction", encode::csr(1, late_result, 0x340, 4), true},
    {"CSR instruction", encode::csr(6, late_result, 0x300, 0), true},
    {"jump to a register", encode::jump_and_link_register(1, place_address, 0), false, true},
    {"mret", encode::trap_return(), false, true},
    {"exception", encode::environment_call(), false, true},
    {"exception", 0x7F, false, true},
    {"exception", encode::load(2, late_result, data_base, 1), false, true},
    {"arithmetic and logic", compressed::nop()},
    {"arithmetic and logic", compressed::add_immediate(1, 3)},
    {"arithmetic and logic", compressed::load_immediate(1, 3)},
    {"arithmetic and logic", compressed::load_upper(1, 3)},
    {"arithmetic and logic", compressed::shift_left(1, 3)},
    {"arithmetic and logic", compressed::short_immediate(1, 9, 3)},
    {"arithmetic and logic", compressed::short_operation(0, 9, 10)},
    {"arithmetic and logic", compressed::move(1, 3)},
    {"arithmetic and logic", compressed::add(1, 3)},
    {"arithmetic and logic", compressed::address_from_sp(9, 16)},
    {"load from memory", compressed::load(late_result, short_data_base, 4), true},
    {"load from memory", compressed::load_from_sp(late_result, 8), true},
    {"store to memory", compressed::store(9, short_data_base, 4)},
    {"store to memory", compressed::store_to_sp(3, 8)},
    {"other branch, not taken", compressed::branch(false, short_data_base, 2)},
    {"branch taken early, not taken", compressed::branch(true, 11, -2)},
    {"other branch, not taken", compressed::branch(false, short_data_base, -2)},
    {"other branch, taken", compressed::branch(true, short_data_base, 2)},
    {"jump", compressed::jump(2)},
    {"jump", compressed::jump_and_link(2)},
    {"jump to a register", compressed::jump_register(place_address), false, true},
    {"jump to a register", compressed::jump_and_link_register(place_address), false, true},
    {"exception", compressed::breakpoint(), false, true},
    {"exception", 0x8002, false, true},
};

const std::vector<Kind> kinds_of_zbb{
    {"arithmetic and logic", encode::operation(4, 0x20, 1, 4, 3)},
    {"arithmetic and logic", encode::operation(6, 0x20, 1, 4, 3)},
    {"arithmetic and logic", encode::operation(7, 0x20, 1, 4, 3)},
    {"arithmetic and logic", encode::operation(1, 0x30, 1, 4, 3)},
    {"arithmetic and logic", encode::operation(5, 0x30, 1, 4, 3)},
    {"arithmetic and logic", encode::rotate_right(1, 4, 13)},
    {"bit manipulation", encode::leading_zeros(late_result, 4), true},
    {"bit manipulation", encode::trailing_zeros(late_result, 4), true},
    {"bit manipulation", encode::population(late_result, 4), true},
    {"bit manipulation", encode::extend_byte(late_result, 4), true},
    {"bit manipulation", encode::extend_half_word(late_result, 4), true},
    {"bit manipulation", encode::zero_extend_half_word(late_result, 4), true},
    {"bit manipulation", encode::combine_bytes(late_result, 4), true},
    {"bit manipulation", encode::reverse_bytes(late_result, 4), true},
    {"bit manipulation", encode::operation(4, 5, late_result, 4, 3), true},
    {"bit manipulation", encode::operation(5, 5, late_result, 4, 3), true},
    {"bit manipulation", encode::operation(6, 5, late_result, 4, 3), true},
    {"bit manipulation", encode::operation(7, 5, late_result, 4, 3), true},
};

std::vector<Kind> kinds_of_this_processor() {
  auto kinds = kinds_of_all;
  if (Chip::has_zbb) {
    kinds.insert(kinds.end(), kinds_of_zbb.begin(), kinds_of_zbb.end());
  } else {
    for (const auto& kind : kinds_of_zbb) {
      kinds.push_back({.row = "exception", .word = kind.word, .placed = true});
    }
  }
  return kinds;
}

const std::vector<Kind> kinds = kinds_of_this_processor();

// Where the instructions under test lie, and what is behind them.
struct Placed {
  std::vector<std::uint8_t> image;
  Word before = 0;
  Word first = 0;
  Word next = 0;
};

// The first of them lies at the begin of a word or, `in_the_middle`, at its second half.
Placed place(const std::vector<Word>& tested, bool in_the_middle, Word handler = 0) {
  ProgramBuilder program;
  Placed placed;
  placed.first = Chip::memory_base + program_bytes + (in_the_middle ? 2 : 0);
  placed.before = placed.first - (in_the_middle ? 2 : 4);
  placed.next = placed.first;
  for (const Word bits : tested) placed.next += (bits & 3) == 3 ? 4 : 2;
  const Word address = handler != 0 ? handler : placed.next;
  for (const Word instruction :
       {encode::load_upper(data_base, 0x8000C000), encode::load_upper(bus_base, 0xF0000000),
        encode::add_immediate(short_data_base, data_base, 64),
        encode::add_immediate(stack_pointer, data_base, 128),
        encode::load_upper(place_address, Chip::memory_base),
        encode::add_immediate(place_address, place_address,
                              static_cast<std::int32_t>(address & 0xFFF)),
        encode::csr(1, 0, 0x341, place_address), encode::csr(1, 0, 0x305, place_address),
        encode::add_immediate(4, 0, -77), encode::add_immediate(3, 0, 5),
        encode::csr(1, 0, 0x304, handler != 0 ? Word{4} : Word{0}),
        encode::csr(6, 0, 0x300, handler != 0 ? Word{8} : Word{0})}) {
    program.add_long(instruction);
  }
  while (program.bytes() < program_bytes) program.add_long(encode::nop());
  if (in_the_middle) program.add_short(compressed::nop());
  for (const Word bits : tested) program.add(bits);
  if (placed.next % 4 != 0) program.add_short(compressed::nop());
  for (int count = 0; count < 12; ++count) program.add_long(encode::nop());
  placed.image = program.image();
  return placed;
}

std::uint64_t clock_at(Chip& chip, Word address) {
  while (const auto event = chip.next_retirement()) {
    if (!event->trap && event->address == address) return event->clock;
  }
  return 0;
}

// The clocks of the instructions together, of which the last may be one that needs its next's
// address.
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

// Traps go to a word: what lies behind a trap must begin one.
unsigned measure_trap(Word instruction) {
  return measure_at({instruction}, (instruction & 3) != 3);
}

TEST(Timing, each_instruction_takes_its_clocks) {
  const auto table = read_table();
  for (const auto& kind : kinds) {
    ASSERT_TRUE(table.contains(kind.row)) << kind.row;
    const bool traps = kind.row == std::string("exception");
    EXPECT_EQ(traps ? measure_trap(kind.word) : measure({kind.word}), table.at(kind.row))
        << kind.row << std::hex << " " << kind.word;
  }
}

TEST(Timing, an_instruction_behind_another_takes_its_own_clocks) {
  const auto table = read_table();
  for (const auto& first : kinds) {
    if (first.placed) continue;
    for (const auto& second : kinds) {
      if (second.row == std::string("exception")) continue;
      EXPECT_EQ(measure({first.word, second.word}), table.at(first.row) + table.at(second.row))
          << first.row << ", " << second.row << std::hex << " " << first.word << " " << second.word;
    }
  }
}

TEST(Timing, a_branch_backwards_takes_its_clocks_where_it_is_taken) {
  const auto table = read_table();
  const unsigned jumps = 2 * table.at("jump");
  const unsigned wanted = jumps + table.at("branch taken early, taken");
  // Over a jump to the end, then back to it.
  EXPECT_EQ(measure({encode::jump_and_link(0, 8), encode::jump_and_link(0, 8),
                     encode::branch(0, 0, 0, -4)}),
            jumps + table.at("other branch, taken"));
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
  const auto table = read_table();
  const unsigned wait = table.at("late result read by the next instruction");
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
    // The same bits as a constant are no reading.
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
  const auto table = read_table();
  for (const Word funct3 : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u}) {
    for (const Word first : {0u, 4u, 3u, 30u, 31u}) {
      for (const Word second : {0u, 4u, 3u, 30u, 31u}) {
        EXPECT_EQ(measure({encode::operation(funct3, 1, 1, first, second)}),
                  table.at(funct3 < 4 ? "multiplication" : "division"));
      }
    }
  }
}

// From the clock in which the request is there to the completion of the handler's first
// instruction.
unsigned latency(Word running, unsigned delay) {
  const Word loop = Chip::memory_base + program_bytes, handler = loop + 12;
  std::vector<Word> tested{running, compressed::nop(), compressed::nop()};
  if ((running & 3) != 3) tested.push_back(compressed::nop());
  tested.push_back(encode::jump_and_link(0, -8));
  Chip chip(place(tested, false, handler).image);
  clock_at(chip, loop);
  for (unsigned count = 0; count < delay; ++count) chip.clock();
  const std::uint64_t begin = chip.clocks();
  chip.device().set_interrupts(1u << 31);
  return static_cast<unsigned>(clock_at(chip, handler) - begin);
}

TEST(Timing, an_interrupt_is_answered_in_its_clocks_whatever_is_executed) {
  const auto table = read_table();
  const unsigned clocks = table.at("interrupt");
  const unsigned bus_wait = table.at("interrupt during a peripheral access, at most more");
  for (const auto& kind : kinds) {
    if (kind.placed) continue;
    const std::string row = kind.row;
    const bool on_bus = row.find("peripheral") != std::string::npos;
    for (unsigned delay = 0; delay < 40; ++delay) {
      const unsigned measured = latency(kind.word, delay);
      EXPECT_GE(measured, clocks) << row << " " << delay;
      EXPECT_LE(measured, clocks + (on_bus ? bus_wait : 0)) << row << " " << delay;
    }
  }
}

}  // namespace
}  // namespace processor
