# SPDX-License-Identifier: Apache-2.0
# Every operation of RV32IM on registers, at the values where it could go wrong.
  .include "check.inc"

# `name` of the two numbers gives the third; also into one of its own sources, and into x0.
  .macro operation name, first, second, result
  li a0, \first
  li a1, \second
  \name a2, a0, a1
  check a2, \result
  \name a0, a0, a1
  check a0, \result
  li a0, \first
  \name a1, a0, a1
  check a1, \result
  \name x0, a0, a1
  check x0, 0
  .endm

  .macro immediate name, first, second, result
  li a0, \first
  \name a2, a0, \second
  check a2, \result
  .endm

  begin
  operation add, 0x7fffffff, 1, 0x80000000
  operation add, 0xffffffff, 1, 0
  operation sub, 0, 1, 0xffffffff
  operation sub, 0x80000000, 1, 0x7fffffff
  operation sll, 1, 31, 0x80000000
  operation sll, 0x12345678, 0x24, 0x23456780
  operation srl, 0x80000000, 31, 1
  operation srl, 0xffffffff, 0x20, 0xffffffff
  operation sra, 0x80000000, 31, 0xffffffff
  operation sra, 0x7fffffff, 30, 1
  operation slt, 0x80000000, 0x7fffffff, 1
  operation slt, 0x7fffffff, 0x80000000, 0
  operation slt, 5, 5, 0
  operation sltu, 0x80000000, 0x7fffffff, 0
  operation sltu, 0, 0xffffffff, 1
  operation xor, 0xff00ff00, 0x0ff00ff0, 0xf0f0f0f0
  operation or, 0xff00ff00, 0x0ff00ff0, 0xfff0fff0
  operation and, 0xff00ff00, 0x0ff00ff0, 0x0f000f00
  operation mul, 0xffffffff, 0xffffffff, 1
  operation mul, 0x12345678, 0x9abcdef0, 0x242d2080
  operation mulh, 0x80000000, 0x80000000, 0x40000000
  operation mulh, 0xffffffff, 1, 0xffffffff
  operation mulh, 0x7fffffff, 0x80000000, 0xc0000000
  operation mulhsu, 0xffffffff, 0xffffffff, 0xffffffff
  operation mulhsu, 0x80000000, 0x80000000, 0xc0000000
  operation mulhu, 0xffffffff, 0xffffffff, 0xfffffffe
  operation mulhu, 0x80000000, 0x80000000, 0x40000000
  operation div, 0xffffffec, 3, 0xfffffffa
  operation div, 20, 0xfffffffd, 0xfffffffa
  operation div, 0x80000000, 0xffffffff, 0x80000000
  operation div, 0xfffffff9, 0, 0xffffffff
  operation div, 0x80000000, 1, 0x80000000
  operation divu, 0xffffffec, 3, 0x5555554e
  operation divu, 7, 0, 0xffffffff
  operation divu, 0x80000000, 0xffffffff, 0
  operation rem, 0xffffffec, 3, 0xfffffffe
  operation rem, 20, 0xfffffffd, 2
  operation rem, 0x80000000, 0xffffffff, 0
  operation rem, 0xfffffff9, 0, 0xfffffff9
  operation remu, 0xffffffec, 3, 2
  operation remu, 7, 0, 7
  operation remu, 0x80000000, 0xffffffff, 0x80000000

  immediate addi, 0x80000000, -1, 0x7fffffff
  immediate addi, 0, 2047, 2047
  immediate slti, 0xffffffff, 0, 1
  immediate slti, 3, -2048, 0
  immediate sltiu, 3, -2048, 1
  immediate sltiu, 0xffffffff, 1, 0
  immediate xori, 0x0f0f0f0f, -1, 0xf0f0f0f0
  immediate ori, 0x0f0f0f0f, 0x70, 0x0f0f0f7f
  immediate andi, 0xffffffff, -16, 0xfffffff0
  immediate slli, 0x00000001, 31, 0x80000000
  immediate srli, 0x80000000, 31, 1
  immediate srai, 0x80000000, 31, 0xffffffff
  immediate srai, 0x80000000, 0, 0x80000000

  lui a0, 0xfffff
  check a0, 0xfffff000
1:
  auipc a0, 1
  la a1, 1b
  sub a0, a0, a1
  check a0, 0x1000
  end
