# SPDX-License-Identifier: Apache-2.0
# Every compressed instruction, at both places in a word, among long ones.
  .include "check.inc"

# `instruction` from a0 = first, a1 = second gives `result` in a0.
  .macro short first, second, result, instruction:vararg
  li a0, \first
  li a1, \second
  .option rvc
  \instruction
  .option norvc
  check a0, \result
  .endm

  .macro short_forms
  short 7, 0, 38, c.addi a0, 31
  short 7, 0, 0xffffffe7, c.addi a0, -32
  short 7, 0, 0xffffffe0, c.li a0, -32
  short 7, 0, 31, c.li a0, 31
  short 7, 0, 0x1f000, c.lui a0, 31
  short 7, 0, 0xfffe0000, c.lui a0, 0xfffe0
  short 0x80000001, 0, 0x40000000, c.srli a0, 1
  short 0x80000000, 0, 1, c.srli a0, 31
  short 0x80000000, 0, 0xffffffff, c.srai a0, 31
  short 0x80000010, 0, 0xf8000001, c.srai a0, 4
  short 0x12345678, 0, 0x12345660, c.andi a0, -32
  short 0x12345678, 0, 0x18, c.andi a0, 31
  short 5, 7, 0xfffffffe, c.sub a0, a1
  short 0xff00ff00, 0x0ff00ff0, 0xf0f0f0f0, c.xor a0, a1
  short 0xff00ff00, 0x0ff00ff0, 0xfff0fff0, c.or a0, a1
  short 0xff00ff00, 0x0ff00ff0, 0x0f000f00, c.and a0, a1
  short 0x12345678, 0, 0x23456780, c.slli a0, 4
  short 1, 0, 0x80000000, c.slli a0, 31
  short 1, 9, 9, c.mv a0, a1
  short 0xffffffff, 1, 0, c.add a0, a1
  # Hints do nothing.
  short 5, 6, 5, c.nop
  short 5, 6, 5, .half 0x007d
  short 5, 6, 5, .half 0x802e
  short 5, 6, 5, .half 0x902e
  short 5, 6, 5, .half 0x4075
  short 5, 6, 5, .half 0x6075

  la sp, place
  li a0, 0
  .option rvc
  c.addi4spn a0, sp, 4
  .option norvc
  check_address a0, place + 4
  .option rvc
  c.addi4spn a0, sp, 1020
  .option norvc
  check_address a0, place + 1020
  .option rvc
  c.addi16sp sp, 496
  .option norvc
  check_address sp, place + 496
  .option rvc
  c.addi16sp sp, -512
  .option norvc
  check_address sp, place - 16
  .option rvc
  c.addi16sp sp, 16
  .option norvc

  li a1, 0x12345678
  .option rvc
  c.swsp a1, 252(sp)
  c.lwsp a0, 252(sp)
  c.addi a0, 1
  .option norvc
  check a0, 0x12345679
  la s1, place
  .option rvc
  c.sw a0, 124(s1)
  c.lw a2, 124(s1)
  .option norvc
  check a2, 0x12345679
  lw a2, 124(sp)
  check a2, 0x12345679
  .option rvc
  c.swsp s1, 0(sp)
  c.lwsp a3, 0(sp)
  c.lw a3, 0(a3)
  .option norvc
  check_address a3, place

  # Jumps and branches between both places.
  li a0, 0
  .option rvc
  c.j 1f
  c.addi a0, 1
1:
  c.addi a0, 2
  c.jal 2f
1:
  c.addi a0, 4
  c.j 3f
2:
  c.addi a0, 8
  c.jr ra
3:
  .option norvc
  check a0, 14
  check_address ra, 1b
  la a1, 2f
  la a2, 3f
  .option rvc
  c.jalr a1
1:
  c.jr a2
2:
  c.jr ra
3:
  .option norvc
  check_address ra, 1b
  # jalr of its own link register.
  la ra, 2f
  .option rvc
  c.jalr ra
1:
  c.nop
2:
  .option norvc
  check_address ra, 1b
  li a0, 0
  li a1, 3
  .option rvc
1:
  c.add a0, a1
  c.addi a1, -1
  c.bnez a1, 1b
  c.beqz a1, 2f
  c.li a0, 0
2:
  c.beqz a0, 3f
  c.bnez a1, 3f
  c.addi a0, 16
3:
  .option norvc
  check a0, 22
  .endm

  begin
  short_forms
  .align 2
  .option rvc
  c.nop
  .option norvc
  short_forms
  .align 2
  # A long instruction that is written over, at the second half of a word.
  la t0, changed
  li t1, 0x0513
  sh t1, 0(t0)
  li t1, 0x0580
  sh t1, 2(t0)
  fence.i
  .option rvc
  c.nop
  .option norvc
changed:
  li a0, 1
  check a0, 88
  end

  .data
  .align 4
  .space 16
place:
  .space 1024
