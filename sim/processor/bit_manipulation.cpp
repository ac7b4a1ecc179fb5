// SPDX-License-Identifier: Apache-2.0
// The instructions of Zbb, from chapter "B" of volume I.
#include <algorithm>
#include <bit>

#include "sim/processor/instructions.hpp"

namespace processor {
namespace {

using Word = std::uint32_t;

std::int32_t as_signed(Word value) { return static_cast<std::int32_t>(value); }

std::optional<Word> of_two_registers(unsigned funct7, unsigned funct3, Word a, Word b) {
  switch (funct7 << 4 | funct3) {
    case 0x204:
      return ~(a ^ b);
    case 0x206:
      return a | ~b;
    case 0x207:
      return a & ~b;
    case 0x301:
      return std::rotl(a, static_cast<int>(b & 31));
    case 0x305:
      return std::rotr(a, static_cast<int>(b & 31));
    case 0x054:
      return static_cast<Word>(std::min(as_signed(a), as_signed(b)));
    case 0x055:
      return std::min(a, b);
    case 0x056:
      return static_cast<Word>(std::max(as_signed(a), as_signed(b)));
    case 0x057:
      return std::max(a, b);
    default:
      return std::nullopt;
  }
}

Word combine_bytes(Word a) {
  Word result = 0;
  for (Word byte = 0xFF; byte != 0; byte <<= 8) {
    if ((a & byte) != 0) result |= byte;
  }
  return result;
}

// `code`: the upper 12 bits.
std::optional<Word> of_one_register(unsigned code, unsigned funct3, Word a) {
  if (funct3 == 5 && code >> 5 == 0x30) return std::rotr(a, static_cast<int>(code & 31));
  switch (code << 4 | funct3) {
    case 0x6001:
      return static_cast<Word>(std::countl_zero(a));
    case 0x6011:
      return static_cast<Word>(std::countr_zero(a));
    case 0x6021:
      return static_cast<Word>(std::popcount(a));
    case 0x6041:
      return static_cast<Word>(static_cast<std::int8_t>(a));
    case 0x6051:
      return static_cast<Word>(static_cast<std::int16_t>(a));
    case 0x2875:
      return combine_bytes(a);
    case 0x6985:
      return std::byteswap(a);
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<Word> bit_manipulation(Word instruction, Word first, Word second) {
  const unsigned opcode = instruction & 0x7F, funct3 = instruction >> 12 & 7;
  const unsigned code = instruction >> 20;
  if (opcode == 0x13) return of_one_register(code, funct3, first);
  if (opcode != 0x33) return std::nullopt;
  // zext.h
  if (code == 0x080 && funct3 == 4) return first & 0xFFFF;
  return of_two_registers(code >> 5, funct3, first, second);
}

}  // namespace processor
