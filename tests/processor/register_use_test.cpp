// SPDX-License-Identifier: Apache-2.0
// Every register as destination and as either operand of every kind of instruction, also of one
// that stands right after the writer: random programs keep some registers for themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "tests/processor/chip.hpp"
#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/program_builder.hpp"

namespace processor {
namespace {

using encode::Word;

constexpr Word registers = 32;

// A program of straight-line code, and what its instructions write.
class Line {
 public:
  Line() {
    for (Word index = 1; index < registers; ++index) set(index, random());
  }

  Word value(Word index) const { return values_[index]; }
  Word random() { return static_cast<Word>(random_()); }
  std::uint32_t bytes() const { return program_.bytes(); }

  // `index` gets `value`, as the host says.
  void add(Word instruction, Word index, Word value) {
    program_.add(instruction);
    values_[index] = index == 0 ? 0 : value;
    expected_.push_back({index, values_[index]});
  }
  void add(Word instruction) { add(instruction, 0, 0); }
  void set(Word index, Word value) {
    const Word upper = (value + 0x800) & 0xFFFFF000;
    add(encode::load_upper(index, upper), index, upper);
    add(encode::add_immediate(index, index, static_cast<std::int32_t>(value - upper)), index,
        value);
  }
  // What is after a jump or branch and is not executed.
  void add_skipped() { program_.add(encode::add_immediate(1, 1, 1)); }

  void check() {
    Chip chip(program_.image());
    for (std::size_t i = 0; i < expected_.size(); ++i) {
      const auto event = chip.next_retirement();
      ASSERT_TRUE(event && !event->trap) << "instruction " << i;
      ASSERT_EQ(event->destination, expected_[i].index) << std::hex << event->instruction;
      if (expected_[i].index != 0) {
        ASSERT_EQ(event->value, expected_[i].value) << std::hex << event->instruction;
      }
    }
  }

 private:
  struct Write {
    Word index;
    Word value;
  };

  std::mt19937 random_{1};
  ProgramBuilder program_;
  std::array<Word, registers> values_{};
  std::vector<Write> expected_;
};

struct Choice {
  Word destination, first, second;
};

// Each combination once, in an order in which every register is soon read that has been written.
std::vector<Choice> all_choices() {
  std::vector<Choice> all;
  for (Word bits = 0; bits < registers * registers * registers; ++bits) {
    all.push_back({bits % registers, bits / registers % registers, bits / registers / registers});
  }
  std::ranges::shuffle(all, std::mt19937{2});
  return all;
}

void add_operation(Line& line, const Choice& choice, Word kind) {
  const auto [destination, first, second] = choice;
  const Word a = line.value(first), b = line.value(second), old = line.value(destination);
  const bool can_be_short = destination != 0 && second != 0;
  switch (kind) {
    case 0:
      return line.add(encode::operation(0, 0, destination, first, second), destination, a + b);
    case 1:
      return line.add(encode::operation(4, 0, destination, first, second), destination, a ^ b);
    case 2:  // late
      return line.add(encode::operation(3, 1, destination, first, second), destination,
                      static_cast<Word>(std::uint64_t{a} * b >> 32));
    case 3:
      if (can_be_short) {
        return line.add(encode::compressed::move(destination, second), destination, b);
      }
      break;
    case 4:
      if (can_be_short) {
        return line.add(encode::compressed::add(destination, second), destination, old + b);
      }
      break;
    default:
      break;
  }
  line.set(destination, line.random());
}

TEST(RegisterUse, of_operations_is_right_for_all_destinations_and_operands) {
  constexpr std::uint32_t bytes_of_a_run = 60'000;
  const auto choices = all_choices();
  std::size_t next = 0;
  while (next < choices.size() && !HasFailure()) {
    Line line;
    for (; next < choices.size() && line.bytes() < bytes_of_a_run; ++next) {
      add_operation(line, choices[next], static_cast<Word>(next % 6));
    }
    line.check();
  }
}

TEST(RegisterUse, of_loads_and_stores_is_right_for_all_bases_and_data) {
  constexpr Word place = 0x8000F800;
  Line line;
  for (Word base = 1; base < registers; ++base) {
    line.set(base, place);
    for (Word data = 0; data < registers; ++data) {
      const auto offset = static_cast<std::int32_t>(4 * (line.random() % 1024)) - 2048;
      line.add(encode::store(2, data, base, offset));
      const Word stored = line.value(data);
      const Word loaded = (data + 1) % registers;
      if (loaded == base) continue;
      line.add(encode::load(2, loaded, base, offset), loaded, stored);
    }
  }
  line.check();
}

TEST(RegisterUse, of_branches_is_right_for_all_pairs) {
  Line line;
  for (Word first = 0; first < registers; ++first) {
    for (Word second = 0; second < registers; ++second) {
      for (const Word less : {6u, 7u}) {  // bltu, bgeu
        const bool taken = (line.value(first) < line.value(second)) == (less == 6);
        line.add(encode::branch(less, first, second, 8));
        if (taken) {
          line.add_skipped();
        } else {
          line.set(1 + line.random() % (registers - 1), line.random());
        }
      }
    }
  }
  line.check();
}

TEST(RegisterUse, of_jumps_is_right_for_all_links_and_targets) {
  Line line;
  for (Word target = 1; target < registers; ++target) {
    for (Word link = 0; link < registers; ++link) {
      line.set(target, Chip::memory_base + line.bytes() + 16);
      line.add(encode::jump_and_link_register(link, target, 0), link,
               Chip::memory_base + line.bytes() + 4);
      line.add_skipped();
      line.add(encode::jump_and_link(link, 8), link, Chip::memory_base + line.bytes() + 4);
      line.add_skipped();
    }
  }
  line.check();
}

}  // namespace
}  // namespace processor
