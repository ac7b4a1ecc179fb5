# SPDX-License-Identifier: Apache-2.0
# Every instruction of Zbb, at the values where it could go wrong; each result is read by the next instruction.
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

  .macro single name, first, result
  li a0, \first
  \name a2, a0
  add a3, a2, x0
  check a3, \result
  \name a0, a0
  check a0, \result
  \name x0, a0
  check x0, 0
  .endm

  .macro rotation first, distance, result
  li a0, \first
  rori a2, a0, \distance
  check a2, \result
  .endm

  begin
  operation andn, 0xff00ff00, 0x0ff00ff0, 0xf000f000
  operation andn, 0xffffffff, 0, 0xffffffff
  operation orn, 0xff00ff00, 0x0ff00ff0, 0xff0fff0f
  operation orn, 0, 0xffffffff, 0
  operation xnor, 0xff00ff00, 0x0ff00ff0, 0x0f0f0f0f
  operation xnor, 0, 0, 0xffffffff
  operation min, 0x80000000, 0x7fffffff, 0x80000000
  operation min, 0x7fffffff, 0x80000000, 0x80000000
  operation min, 5, 5, 5
  operation min, 0xffffffff, 0xfffffffe, 0xfffffffe
  operation minu, 0x80000000, 0x7fffffff, 0x7fffffff
  operation minu, 0, 0xffffffff, 0
  operation max, 0x80000000, 0x7fffffff, 0x7fffffff
  operation max, 0x7fffffff, 0x80000000, 0x7fffffff
  operation max, 0xffffffff, 0xfffffffe, 0xffffffff
  operation maxu, 0x80000000, 0x7fffffff, 0x80000000
  operation maxu, 0xffffffff, 0, 0xffffffff
  operation rol, 0x12345678, 4, 0x23456781
  operation rol, 0x80000001, 0, 0x80000001
  operation rol, 0x80000001, 31, 0xc0000000
  operation rol, 0x12345678, 0x28, 0x34567812
  operation ror, 0x12345678, 4, 0x81234567
  operation ror, 0x80000001, 32, 0x80000001
  operation ror, 0x80000001, 31, 0x00000003
  operation ror, 0xdeadbeef, 0xfffffff0, 0xbeefdead
  rotation 0x12345678, 0, 0x12345678
  rotation 0x12345678, 1, 0x091a2b3c
  rotation 0x00000001, 1, 0x80000000
  rotation 0x12345678, 31, 0x2468acf0

  single clz, 0, 32
  single clz, 1, 31
  single clz, 0xffffffff, 0
  single clz, 0x00008000, 16
  single clz, 0x00010000, 15
  single clz, 0x00ffffff, 8
  single ctz, 0, 32
  single ctz, 1, 0
  single ctz, 0x80000000, 31
  single ctz, 0x00010000, 16
  single ctz, 0xffff8000, 15
  single cpop, 0, 0
  single cpop, 0xffffffff, 32
  single cpop, 0x80000001, 2
  single cpop, 0x12345678, 13
  single sext.b, 0x12345680, 0xffffff80
  single sext.b, 0xffffff7f, 0x7f
  single sext.h, 0x12348000, 0xffff8000
  single sext.h, 0xffff7fff, 0x7fff
  single zext.h, 0xffff8000, 0x8000
  single zext.h, 0x12340000, 0
  single rev8, 0x12345678, 0x78563412
  single rev8, 0x000000ff, 0xff000000
  single orc.b, 0x01000080, 0xff0000ff
  single orc.b, 0x00100100, 0x00ffff00
  single orc.b, 0, 0

# Not one of them: the same words with one bit more.
  la t0, 1f
  csrw mtvec, t0
  .word 0x60359513
  j failed
  .align 2
1:
  csrr a0, mcause
  check a0, 2
  csrr a0, mtval
  check a0, 0x60359513
  la t0, unexpected_trap
  csrw mtvec, t0
  end
