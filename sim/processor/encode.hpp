// SPDX-License-Identifier: Apache-2.0
// Instruction words from their parts, for programs that a test makes itself.
#pragma once

#include <cstdint>

namespace processor::encode {

using Word = std::uint32_t;

constexpr Word register_type(Word opcode, Word funct3, Word funct7, Word rd, Word rs1, Word rs2) {
  return opcode | rd << 7 | funct3 << 12 | rs1 << 15 | rs2 << 20 | funct7 << 25;
}
constexpr Word immediate_type(Word opcode, Word funct3, Word rd, Word rs1, std::int32_t immediate) {
  return opcode | rd << 7 | funct3 << 12 | rs1 << 15 | static_cast<Word>(immediate) << 20;
}
constexpr Word operation(Word funct3, Word funct7, Word rd, Word rs1, Word rs2) {
  return register_type(0x33, funct3, funct7, rd, rs1, rs2);
}
constexpr Word operation_immediate(Word funct3, Word rd, Word rs1, std::int32_t immediate) {
  return immediate_type(0x13, funct3, rd, rs1, immediate);
}
// Zbb's with one register: the upper 12 bits say which.
constexpr Word of_one_register(Word code, Word funct3, Word rd, Word rs1) {
  return 0x13 | rd << 7 | funct3 << 12 | rs1 << 15 | code << 20;
}
constexpr Word leading_zeros(Word rd, Word rs1) { return of_one_register(0x600, 1, rd, rs1); }
constexpr Word trailing_zeros(Word rd, Word rs1) { return of_one_register(0x601, 1, rd, rs1); }
constexpr Word population(Word rd, Word rs1) { return of_one_register(0x602, 1, rd, rs1); }
constexpr Word extend_byte(Word rd, Word rs1) { return of_one_register(0x604, 1, rd, rs1); }
constexpr Word extend_half_word(Word rd, Word rs1) { return of_one_register(0x605, 1, rd, rs1); }
constexpr Word combine_bytes(Word rd, Word rs1) { return of_one_register(0x287, 5, rd, rs1); }
constexpr Word reverse_bytes(Word rd, Word rs1) { return of_one_register(0x698, 5, rd, rs1); }
constexpr Word rotate_right(Word rd, Word rs1, Word distance) {
  return of_one_register(0x600 | distance, 5, rd, rs1);
}
constexpr Word zero_extend_half_word(Word rd, Word rs1) { return operation(4, 4, rd, rs1, 0); }
constexpr Word add_immediate(Word rd, Word rs1, std::int32_t immediate) {
  return operation_immediate(0, rd, rs1, immediate);
}
constexpr Word nop() { return add_immediate(0, 0, 0); }
constexpr Word load(Word funct3, Word rd, Word base, std::int32_t offset) {
  return immediate_type(0x03, funct3, rd, base, offset);
}
constexpr Word store(Word funct3, Word source, Word base, std::int32_t offset) {
  const auto bits = static_cast<Word>(offset);
  return 0x23 | (bits & 31) << 7 | funct3 << 12 | base << 15 | source << 20 |
         (bits >> 5 & 0x7F) << 25;
}
constexpr Word branch(Word funct3, Word rs1, Word rs2, std::int32_t offset) {
  const auto bits = static_cast<Word>(offset);
  return 0x63 | (bits >> 11 & 1) << 7 | (bits >> 1 & 15) << 8 | funct3 << 12 | rs1 << 15 |
         rs2 << 20 | (bits >> 5 & 63) << 25 | (bits >> 12 & 1) << 31;
}
constexpr Word jump_and_link(Word rd, std::int32_t offset) {
  const auto bits = static_cast<Word>(offset);
  return 0x6F | rd << 7 | (bits >> 12 & 0xFF) << 12 | (bits >> 11 & 1) << 20 |
         (bits >> 1 & 0x3FF) << 21 | (bits >> 20 & 1) << 31;
}
constexpr Word jump_and_link_register(Word rd, Word rs1, std::int32_t offset) {
  return immediate_type(0x67, 0, rd, rs1, offset);
}
constexpr Word load_upper(Word rd, Word value) { return 0x37 | rd << 7 | (value & 0xFFFFF000); }
constexpr Word add_upper_to_pc(Word rd, Word value) {
  return 0x17 | rd << 7 | (value & 0xFFFFF000);
}
// `source`: a register, or with funct3 5 to 7 a number up to 31.
constexpr Word csr(Word funct3, Word rd, Word address, Word source) {
  return 0x73 | rd << 7 | funct3 << 12 | source << 15 | address << 20;
}
constexpr Word fence() { return 0x0FF0000F; }
constexpr Word fence_i() { return 0x0000100F; }
constexpr Word environment_call() { return 0x00000073; }
constexpr Word breakpoint() { return 0x00100073; }
constexpr Word trap_return() { return 0x30200073; }
constexpr Word wait_for_interrupt() { return 0x10500073; }

}  // namespace processor::encode
