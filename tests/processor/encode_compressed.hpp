// SPDX-License-Identifier: Apache-2.0
// Compressed instructions from their parts, for programs that a test makes itself. Short registers
// are x8 to x15; offsets count bytes.
#pragma once

#include "sim/processor/encode.hpp"

namespace processor::encode::compressed {

// Bit `from` of the value at place `to`.
constexpr Word moved(std::int32_t value, unsigned from, unsigned to) {
  return (static_cast<Word>(value) >> from & 1) << to;
}
constexpr Word immediate_type(Word quadrant, Word funct3, Word rd, std::int32_t immediate) {
  return quadrant | funct3 << 13 | rd << 7 | (static_cast<Word>(immediate) & 31) << 2 |
         moved(immediate, 5, 12);
}
constexpr Word add_immediate(Word rd, std::int32_t immediate) {
  return immediate_type(1, 0, rd, immediate);
}
constexpr Word nop() { return add_immediate(0, 0); }
constexpr Word load_immediate(Word rd, std::int32_t immediate) {
  return immediate_type(1, 2, rd, immediate);
}
// `immediate` is not 0 and rd is not x2.
constexpr Word load_upper(Word rd, std::int32_t immediate) {
  return immediate_type(1, 3, rd, immediate);
}
constexpr Word shift_left(Word rd, std::int32_t distance) {
  return immediate_type(2, 0, rd, distance);
}
// 0 srli, 1 srai, 2 andi.
constexpr Word short_immediate(Word which, Word rd, std::int32_t immediate) {
  return immediate_type(1, 4, which << 3 | (rd - 8), immediate);
}
// 0 sub, 1 xor, 2 or, 3 and.
constexpr Word short_operation(Word which, Word rd, Word rs2) {
  return 0x8C01 | (rd - 8) << 7 | which << 5 | (rs2 - 8) << 2;
}
constexpr Word move(Word rd, Word rs2) { return 0x8002 | rd << 7 | rs2 << 2; }
constexpr Word add(Word rd, Word rs2) { return 0x9002 | rd << 7 | rs2 << 2; }
constexpr Word jump_register(Word rs1) { return 0x8002 | rs1 << 7; }
constexpr Word jump_and_link_register(Word rs1) { return 0x9002 | rs1 << 7; }
constexpr Word breakpoint() { return 0x9002; }
// A multiple of 16 that is not 0.
constexpr Word add_to_sp(std::int32_t amount) {
  return 0x6101 | moved(amount, 9, 12) | moved(amount, 8, 4) | moved(amount, 7, 3) |
         moved(amount, 6, 5) | moved(amount, 5, 2) | moved(amount, 4, 6);
}
// A multiple of 4 that is not 0.
constexpr Word address_from_sp(Word rd, std::int32_t offset) {
  return (rd - 8) << 2 | (static_cast<Word>(offset) >> 6 & 15) << 7 | moved(offset, 5, 12) |
         moved(offset, 4, 11) | moved(offset, 3, 5) | moved(offset, 2, 6);
}
constexpr Word word_access(Word funct3, Word data, Word base, std::int32_t offset) {
  return funct3 << 13 | (data - 8) << 2 | (base - 8) << 7 |
         (static_cast<Word>(offset) >> 3 & 7) << 10 | moved(offset, 6, 5) | moved(offset, 2, 6);
}
constexpr Word load(Word rd, Word base, std::int32_t offset) {
  return word_access(2, rd, base, offset);
}
constexpr Word store(Word source, Word base, std::int32_t offset) {
  return word_access(6, source, base, offset);
}
constexpr Word load_from_sp(Word rd, std::int32_t offset) {
  return 0x4002 | rd << 7 | (static_cast<Word>(offset) >> 6 & 3) << 2 | moved(offset, 5, 12) |
         (static_cast<Word>(offset) >> 2 & 7) << 4;
}
constexpr Word store_to_sp(Word source, std::int32_t offset) {
  return 0xC002 | source << 2 | (static_cast<Word>(offset) >> 6 & 3) << 7 |
         (static_cast<Word>(offset) >> 2 & 15) << 9;
}
constexpr Word jump_type(Word funct3, std::int32_t offset) {
  return 1 | funct3 << 13 | moved(offset, 11, 12) | moved(offset, 10, 8) |
         (static_cast<Word>(offset) >> 8 & 3) << 9 | moved(offset, 7, 6) | moved(offset, 6, 7) |
         moved(offset, 5, 2) | moved(offset, 4, 11) | (static_cast<Word>(offset) >> 1 & 7) << 3;
}
constexpr Word jump(std::int32_t offset) { return jump_type(5, offset); }
constexpr Word jump_and_link(std::int32_t offset) { return jump_type(1, offset); }
constexpr Word branch(bool not_zero, Word rs1, std::int32_t offset) {
  return 0xC001 | (not_zero ? 0x2000u : 0u) | (rs1 - 8) << 7 | moved(offset, 8, 12) |
         (static_cast<Word>(offset) >> 6 & 3) << 5 | moved(offset, 5, 2) |
         (static_cast<Word>(offset) >> 3 & 3) << 10 | (static_cast<Word>(offset) >> 1 & 3) << 3;
}

}  // namespace processor::encode::compressed
