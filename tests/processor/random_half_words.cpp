// SPDX-License-Identifier: Apache-2.0
// Random instructions of 16 bits.
#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/random_instructions.hpp"

namespace processor {
namespace {

using encode::Word;

namespace compressed = encode::compressed;

std::int32_t tiny_immediate(RandomText& text) {
  return static_cast<std::int32_t>(text.below(64)) - 32;
}

// A multiple of 4 below 4 * `words`.
std::int32_t word_offset(RandomText& text, Word words) {
  return 4 * static_cast<std::int32_t>(text.below(words));
}

// There and back: the stack pointer stays where its data are, whatever jumps in between.
void add_stack_move(RandomText& text) {
  if (text.one_in(8)) return text.emit(compressed::breakpoint());
  const std::int32_t amount = 16 * (1 + static_cast<std::int32_t>(text.below(2)));
  text.emit(compressed::add_to_sp(amount));
  text.emit(compressed::add_to_sp(-amount));
}

void add_load(RandomText& text) {
  if (text.one_in(2)) {
    const Word rd = text.destination();
    return text.emit(compressed::load_from_sp(rd == 0 ? 1 : rd, word_offset(text, 64)));
  }
  text.emit(compressed::load(text.short_destination(), random_registers::short_data_base,
                             word_offset(text, 32)));
}

void add_store(RandomText& text) {
  if (text.one_in(2)) {
    return text.emit(compressed::store_to_sp(text.source(), word_offset(text, 64)));
  }
  text.emit(compressed::store(text.short_source(), random_registers::short_data_base,
                              word_offset(text, 32)));
}

void add_jump(RandomText& text) {
  const std::size_t here = text.program.size(), target = text.target_ahead();
  if (text.one_in(2)) {
    const Word rs1 = text.short_source();
    const bool not_zero = text.one_in(2);
    return text.program.add_distance(
        here, target, [=](std::int32_t bytes) { return compressed::branch(not_zero, rs1, bytes); });
  }
  const Word kind = text.one_in(2) ? 1 : 5;
  text.program.add_distance(here, target,
                            [=](std::int32_t bytes) { return compressed::jump_type(kind, bytes); });
}

// Anything but what could jump or store, or write where only fixed values may stand.
Word wild_half_word(RandomText& text) {
  while (true) {
    const Word half_word = text.below(0x10000);
    const Word quadrant = half_word & 3, funct3 = half_word >> 13, rd = half_word >> 7 & 31;
    const Word short_rd = 8 + (quadrant == 0 ? half_word >> 2 & 7 : half_word >> 7 & 7);
    const bool is_short = quadrant == 0 || (quadrant == 1 && funct3 == 4);
    const bool moves = (quadrant != 1 && funct3 == 6) ||
                       (quadrant == 1 && (funct3 % 4 == 1 || funct3 >= 6)) ||
                       (quadrant == 2 && funct3 == 4 && (half_word >> 2 & 31) == 0 && rd != 0);
    const bool portable = quadrant != 0 || funct3 != 2;
    if (quadrant != 3 && !moves && (portable || !text.settings.portable) &&
        RandomText::may_be_written(is_short ? short_rd : rd)) {
      return half_word;
    }
  }
}

}  // namespace

void add_random_half_word(RandomText& text) {
  if (text.wild()) return text.emit(wild_half_word(text));
  const std::int32_t nonzero = 1 + static_cast<std::int32_t>(text.below(31));
  switch (text.below(16)) {
    case 0:
      return text.emit(compressed::add_immediate(text.destination(), tiny_immediate(text)));
    case 1:
      return text.emit(compressed::load_immediate(text.destination(), tiny_immediate(text)));
    case 2:
      return text.emit(
          compressed::load_upper(text.destination(), text.one_in(2) ? nonzero : -nonzero));
    case 3:
      return text.emit(compressed::shift_left(text.destination(), nonzero));
    case 4:
    case 5:
      return text.emit(
          compressed::short_immediate(text.below(2), text.short_destination(), nonzero));
    case 6:
      return text.emit(
          compressed::short_immediate(2, text.short_destination(), tiny_immediate(text)));
    case 7:
    case 8:
      return text.emit(compressed::short_operation(text.below(4), text.short_destination(),
                                                   text.short_source()));
    case 9:
      return text.emit(compressed::move(text.destination(), 1 + text.below(25)));
    case 10:
      return text.emit(compressed::add(text.destination(), 1 + text.below(25)));
    case 11:
      return text.emit(compressed::address_from_sp(text.short_destination(), 4 * nonzero * 8));
    case 12:
      return add_load(text);
    case 13:
      return add_store(text);
    case 14:
      return add_jump(text);
    default:
      return add_stack_move(text);
  }
}

}  // namespace processor
