// SPDX-License-Identifier: Apache-2.0
// Instructions of all rows of the table of times, and programs around a few of them.
#include "tests/processor/timing_kinds.hpp"

#include "tests/processor/chip.hpp"
#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/program_builder.hpp"

namespace processor {
namespace {

using encode::Word;
using namespace timed;
namespace compressed = encode::compressed;

// A function: a vector of this file could be used before it is initialised.
std::vector<Kind> kinds_of_all() {
  return {
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
      {"branch predicted not taken, not taken", encode::branch(1, 0, 0, 4)},
      {"branch predicted not taken, not taken", encode::branch(4, 4, 4, 4)},
      {"branch predicted taken, not taken", encode::branch(1, 0, 0, -4)},
      {"branch predicted taken, not taken", encode::branch(7, 3, 4, -8)},
      {"branch predicted taken, not taken", encode::branch(5, 4, 3, -8)},
      {"branch predicted not taken, not taken", encode::branch(4, 4, 4, -8)},
      {"branch predicted not taken, not taken", encode::branch(0, 3, 4, -4)},
      {"branch predicted not taken, taken", encode::branch(0, 0, 0, 4)},
      {"branch predicted not taken, taken", encode::branch(7, 4, 4, 4)},
      {"jump", encode::jump_and_link(1, 4)},
      {"fence.i", encode::fence_i()},
      {"CSR instruction", encode::csr(1, late_result, 0x340, 4), true},
      {"CSR instruction", encode::csr(6, late_result, 0x300, 0), true},
      {"jump to a register", encode::jump_and_link_register(1, place_address, 0), false, true},
      {"mret", encode::trap_return(), false, true},
      {"exception", encode::environment_call(), false, true},
      {"exception", 0x7F, false, true},
      {"exception", encode::load(2, late_result, data_base, 1), false, true},
      {"refused access", encode::load(2, late_result, bus_base, 0x200), false, true},
      {"refused access", encode::store(1, 3, bus_base, 0x202), false, true},
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
      {"branch predicted not taken, not taken", compressed::branch(false, short_data_base, 2)},
      {"branch predicted taken, not taken", compressed::branch(true, 11, -2)},
      {"branch predicted not taken, not taken", compressed::branch(false, short_data_base, -2)},
      {"branch predicted not taken, taken", compressed::branch(true, short_data_base, 2)},
      {"jump", compressed::jump(2)},
      {"jump", compressed::jump_and_link(2)},
      {"jump to a register", compressed::jump_register(place_address), false, true},
      {"jump to a register", compressed::jump_and_link_register(place_address), false, true},
      {"exception", compressed::breakpoint(), false, true},
      {"exception", 0x8002, false, true},
  };
}

std::vector<Kind> kinds_of_zbb() {
  return {
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
}

std::vector<Kind> kinds_of_this_processor() {
  auto kinds = kinds_of_all();
  const auto with_zbb = kinds_of_zbb();
  if (Chip::has_zbb) {
    kinds.insert(kinds.end(), with_zbb.begin(), with_zbb.end());
  } else {
    for (const auto& kind : with_zbb) {
      kinds.push_back({.row = "exception", .word = kind.word, .placed = true});
    }
  }
  return kinds;
}

}  // namespace

const std::vector<Kind>& kinds_of_instructions() {
  static const std::vector<Kind> kinds = kinds_of_this_processor();
  return kinds;
}

Placed place(const std::vector<Word>& tested, bool in_the_middle, Word handler) {
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

}  // namespace processor
