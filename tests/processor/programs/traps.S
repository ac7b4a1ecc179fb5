# SPDX-License-Identifier: Apache-2.0
# Every exception: its cause, the instruction's address, its value, and that the instruction did
# nothing.
  .include "check.inc"

# The instruction traps with `cause`; mepc is its own address; mtval is in s1. a0 must stay as it
# was.
  .macro traps cause, instruction:vararg
  li a0, 0x1234
  la s0, 1f
  sw zero, 0(s11)
1:
  \instruction
  check s2, \cause
  sub t0, s3, s0
  check t0, 0
  sub t0, s4, s1
  check t0, 0
  check a0, 0x1234
  .endm

  .macro illegal word
  li s1, \word
  traps 2, .word \word
  .endm

  begin
  la t0, handler
  csrw mtvec, t0
  la s11, place

  li s1, 0
  traps 11, ecall
  la s1, 1f
  li a0, 0x1234
  li s2, 0
1:
  ebreak
  check s2, 3
  check_address s3, 1b
  check_address s4, 1b

  # What is no instruction.
  illegal 0x00000000
  illegal 0xffffffff
  illegal 0x0000007f
  illegal 0x00100501
  illegal 0x02051513
  illegal 0x02055513
  illegal 0xc0055513
  illegal 0x40051513
  illegal 0x04b50533
  illegal 0x40b52533
  illegal 0x00051567
  illegal 0x00b52463
  illegal 0x00b53463
  illegal 0x0005b503
  illegal 0x0005e503
  illegal 0x0005f503
  illegal 0x00b5b023
  illegal 0x0000200f
  illegal 0x10200073
  illegal 0x10500173
  illegal 0x30200473
  illegal 0x00200073
  illegal 0x12000073
  illegal 0x00004073
  illegal 0x1005252f
  illegal 0x00052507
  # CSRs that are not there, and writes to those that can only be read.
  illegal 0x18001573
  illegal 0x3a001573
  illegal 0x3b002573
  illegal 0x10002573
  illegal 0x30202573
  illegal 0x30302573
  illegal 0x30602573
  illegal 0x7a202573
  illegal 0x7b002573
  illegal 0xc0102573
  illegal 0xc0302573
  illegal 0xb0102573
  illegal 0x32102573
  illegal 0xf1451573
  illegal 0xc0001573
  illegal 0xf110e573

  # Misaligned.
  la s1, place + 1
  traps 4, lh a0, 1(s11)
  traps 4, lhu a0, 1(s11)
  traps 4, lw a0, 1(s11)
  la s1, place + 2
  traps 4, lw a0, 2(s11)
  la s1, place + 3
  traps 4, lw a0, 3(s11)
  la s1, place + 1
  traps 6, sh a0, 1(s11)
  traps 6, sw a0, 1(s11)
  la s1, place + 2
  traps 6, sw a0, 2(s11)
  lw t0, 0(s11)
  check t0, 0
  li s10, device
  li s1, device + 1
  traps 4, lw a0, 1(s10)
  traps 6, sh a0, 1(s10)

  # Where nothing answers.
  li s10, 0xf0004000
  li s1, 0xf0004000
  traps 5, lw a0, 0(s10)
  traps 7, sw a0, 0(s10)
  li s10, 0x7ffffffc
  li s1, 0x7ffffffc
  traps 5, lw a0, 0(s10)
  li s10, 0x80010000
  li s1, 0x80010000
  traps 7, sb a0, 0(s10)
  li s1, 3
  li s10, 0
  traps 5, lb a0, 3(s10)

  # Jumps to the middle of a word: the link register stays as it was.
  la s10, target
  la s1, target + 2
  traps 0, jalr a0, 2(s10)
  traps 0, jalr a0, 3(s10)
  traps 0, jal a0, target + 2
  traps 0, beq zero, zero, target + 2
  # Not taken it may lead wherever it wants.
  li s2, 99
  bne zero, zero, target + 2
  check s2, 99

  # A jump out of the memory: the jump is done, its target traps.
  la s9, outside
  la t0, outside_handler
  csrw mtvec, t0
  li s10, 0x90000000
  jalr a0, 0(s10)
outside:
  check s2, 1
  check s3, 0x90000000
  check s4, 0x90000000
  check_address a0, outside
  j done

  .align 2
handler:
  csrr s2, mcause
  csrr s3, mepc
  csrr s4, mtval
  addi t0, s3, 4
  csrw mepc, t0
  mret

  .align 2
outside_handler:
  csrr s2, mcause
  csrr s3, mepc
  csrr s4, mtval
  csrw mepc, s9
  mret

  .align 2
target:
  j failed
  j failed
done:
  end

  .data
  .align 2
place:
  .space 16
