// SPDX-License-Identifier: Apache-2.0
// Random instructions of 32 bits.
#include <array>
#include <utility>

#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/random_instructions.hpp"

namespace processor {
namespace {

using encode::Word;

void add_bit_manipulation(RandomText& text) {
  const Word rd = text.destination(), first = text.source(), second = text.source();
  switch (text.below(11)) {
    case 0:
      return text.emit(encode::leading_zeros(rd, first));
    case 1:
      return text.emit(encode::trailing_zeros(rd, first));
    case 2:
      return text.emit(encode::population(rd, first));
    case 3:
      return text.emit(encode::extend_byte(rd, first));
    case 4:
      return text.emit(text.one_in(2) ? encode::extend_half_word(rd, first)
                                      : encode::zero_extend_half_word(rd, first));
    case 5:
      return text.emit(encode::combine_bytes(rd, first));
    case 6:
      return text.emit(encode::reverse_bytes(rd, first));
    case 7:
      return text.emit(encode::rotate_right(rd, first, text.below(32)));
    case 8:
      return text.emit(encode::operation(text.one_in(2) ? 1 : 5, 0x30, rd, first, second));
    case 9:
      return text.emit(encode::operation(4 + text.below(4), 5, rd, first, second));
    default: {
      constexpr std::array<Word, 3> inverting{4, 6, 7};
      return text.emit(encode::operation(inverting[text.below(3)], 0x20, rd, first, second));
    }
  }
}

void add_operation(RandomText& text) {
  if (text.settings.zbb && text.one_in(2)) return add_bit_manipulation(text);
  const Word funct3 = text.below(8);
  const bool alternate = (funct3 == 0 || funct3 == 5) && text.one_in(2);
  text.emit(encode::operation(funct3, alternate ? 0x20 : 0, text.destination(), text.source(),
                              text.source()));
}

void add_multiplication_or_division(RandomText& text) {
  text.emit(encode::operation(text.below(8), 1, text.destination(), text.source(), text.source()));
}

void add_immediate_operation(RandomText& text) {
  const Word funct3 = text.below(8);
  std::int32_t immediate = static_cast<std::int32_t>(text.below(4096)) - 2048;
  if (funct3 == 1) immediate &= 31;
  if (funct3 == 5) immediate &= 0x41F;
  text.emit(encode::operation_immediate(funct3, text.destination(), text.source(), immediate));
}

void add_upper_immediate(RandomText& text) {
  text.emit(text.one_in(2) ? encode::load_upper(text.destination(), text.interesting_value())
                           : encode::add_upper_to_pc(text.destination(), text.interesting_value()));
}

// Mostly a place in memory, sometimes on the bus, rarely misaligned or where nothing answers.
std::pair<Word, std::int32_t> place(RandomText& text, Word size) {
  std::int32_t offset = static_cast<std::int32_t>(text.below(256)) - 128;
  if (text.settings.portable || !text.one_in(12)) offset &= -static_cast<std::int32_t>(1u << size);
  if (!text.one_in(6)) return {random_registers::data_base, offset};
  return {random_registers::bus_base, text.one_in(5) ? offset + 0x400 : (offset & 0xFF)};
}

void add_load(RandomText& text) {
  constexpr std::array<Word, 5> kinds{0, 1, 2, 4, 5};
  const Word funct3 = kinds[text.below(kinds.size())];
  const auto [base, offset] = place(text, funct3 & 3);
  text.emit(encode::load(funct3, text.destination(), base, offset));
}

void add_store(RandomText& text) {
  const Word funct3 = text.below(3);
  const auto [base, offset] = place(text, funct3);
  text.emit(encode::store(funct3, text.source(), base, offset));
}

void add_branch(RandomText& text) {
  constexpr std::array<Word, 6> kinds{0, 1, 4, 5, 6, 7};
  const Word kind = kinds[text.below(kinds.size())];
  const Word first = text.source(), second = text.source();
  text.program.add_distance(text.program.size(), text.target_ahead(), [=](std::int32_t bytes) {
    return encode::branch(kind, first, second, bytes);
  });
}

// To an address in a register, through its constant or by what is added before.
void add_computed_jump(RandomText& text, Word rd) {
  constexpr Word base = random_registers::jump_base;
  const std::size_t here = text.program.size();
  text.emit(encode::add_upper_to_pc(base, 0));
  const std::int32_t odd = text.one_in(4) ? 1 : 0;
  if (text.one_in(2)) {
    return text.program.add_distance(here, text.target_ahead(), [=](std::int32_t bytes) {
      return encode::jump_and_link_register(rd, base, bytes + odd);
    });
  }
  const std::size_t target = text.target_ahead() + 1;
  text.add_target(target);
  text.program.add_distance(here, target, [=](std::int32_t bytes) {
    return encode::add_immediate(base, base, bytes + odd);
  });
  text.emit(text.one_in(2) ? encode::compressed::jump_register(base)
                           : encode::compressed::jump_and_link_register(base));
}

void add_jump(RandomText& text) {
  const Word rd = text.one_in(4) ? random_registers::jump_base : text.destination();
  const std::size_t here = text.program.size();
  if (!text.one_in(2) && !text.is_target(here + 1, here + 2)) return add_computed_jump(text, rd);
  text.program.add_distance(here, text.target_ahead(),
                            [=](std::int32_t bytes) { return encode::jump_and_link(rd, bytes); });
}

// Anything but what could jump, store, or change where traps lead and whether interrupts come.
Word wild_word(RandomText& text) {
  while (true) {
    const Word word = text.any_word() | 3;
    const Word opcode = word & 0x7F, csr = word >> 20;
    const bool moves = opcode == 0x6F || opcode == 0x67 || opcode == 0x63 || opcode == 0x23;
    const bool is_system = opcode == 0x73;
    const bool forbidden =
        is_system &&
        (csr == csr_numbers::mtvec || csr == csr_numbers::mie || csr == csr_numbers::mstatus ||
         word == encode::wait_for_interrupt() || word == encode::trap_return());
    const bool portable = !is_system && opcode != 0x03;
    if (!moves && !forbidden && (portable || !text.settings.portable) &&
        RandomText::may_be_written(word >> 7 & 31)) {
      return word;
    }
  }
}

}  // namespace

void add_random_word(RandomText& text) {
  if (text.wild()) return text.emit(wild_word(text));
  switch (text.below(text.settings.interrupts ? 22 : 20)) {
    case 0:
    case 1:
    case 2:
    case 3:
      return add_operation(text);
    case 4:
    case 5:
    case 6:
      return add_immediate_operation(text);
    case 7:
      return add_upper_immediate(text);
    case 8:
    case 9:
    case 10:
      return add_multiplication_or_division(text);
    case 11:
    case 12:
    case 13:
      return add_load(text);
    case 14:
    case 15:
      return add_store(text);
    case 16:
    case 17:
      return add_branch(text);
    case 18:
      return add_jump(text);
    default:
      return add_random_system_instruction(text);
  }
}

}  // namespace processor
