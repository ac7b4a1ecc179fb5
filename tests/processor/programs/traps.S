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
  illegal 0xffffffff
  illegal 0x0000007f
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
  illegal 0x7a402573
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

  # Reserved compressed instructions: mtval has the half word alone.
  .macro illegal_half half_word
  li s1, \half_word
  traps 2, .half \half_word, 0x0001
  .endm
  illegal_half 0x0000
  illegal_half 0x0004
  illegal_half 0x2000
  illegal_half 0x6000
  illegal_half 0x8000
  illegal_half 0xa000
  illegal_half 0xe000
  illegal_half 0x6501
  illegal_half 0x6101
  illegal_half 0x9105
  illegal_half 0x9505
  illegal_half 0x9c01
  illegal_half 0x9c41
  illegal_half 0x1502
  illegal_half 0x4002
  illegal_half 0x2002
  illegal_half 0x6002
  illegal_half 0x8002
  illegal_half 0xa002
  illegal_half 0xe002

  # Traps at the second half of a word: of short instructions, and of long ones.
  .option rvc
  la s0, 1f
  c.nop
1:
  c.ebreak
  check s2, 3
  check_address s3, 1b
  check_address s4, 1b
  .option norvc
  .align 2
  .option rvc
  c.nop
  .option norvc
1:
  ecall
  check s2, 11
  check_address s3, 1b
1:
  .word 0x0000007f
  check s2, 2
  check_address s3, 1b
  check s4, 0x0000007f
  .option rvc
  c.nop
  .option norvc
  la s8, place + 1
  .option rvc
  c.mv a1, s8
1:
  c.lw a0, 0(a1)
  .option norvc
  check s2, 4
  check_address s3, 1b
  check_address s4, place + 1
  .option rvc
1:
  c.sw a0, 0(a1)
  .option norvc
  check s2, 6
  check_address s3, 1b
  check_address s4, place + 1

  # A jump out of the memory: the jump is done, its target traps.
  la t0, outside_handler
  csrw mtvec, t0
  la s9, outside
  li s10, 0x90000003
  jalr a0, 0(s10)
outside:
  check s2, 1
  check s3, 0x90000002
  check s4, 0x90000002
  check_address a0, outside
  # The last half word of the memory: a short instruction fits, after it nothing does.
  la s9, end_reached
  li s10, 0x8000fffe
  li a0, 0x00010505
  sh a0, 0(s10)
  fence.i
  li a0, 6
  jr s10
end_reached:
  check s2, 1
  check s3, 0x80010000
  check s4, 0x80010000
  check a0, 7
  # A long one does not fit: its second half is what is at fault.
  la s9, end_crossed
  li a0, 0x0513
  sh a0, 0(s10)
  fence.i
  jr s10
end_crossed:
  check s2, 1
  check s3, 0x8000fffe
  check s4, 0x80010000
  j done

  .align 2
handler:
  csrr s2, mcause
  csrr s3, mepc
  csrr s4, mtval
  lhu t1, 0(s3)
  andi t1, t1, 3
  addi t0, s3, 2
  addi t1, t1, -3
  bnez t1, 1f
  addi t0, t0, 2
1:
  csrw mepc, t0
  mret

  .align 2
outside_handler:
  csrr s2, mcause
  csrr s3, mepc
  csrr s4, mtval
  csrw mepc, s9
  mret

done:
  end

  .data
  .align 2
place:
  .space 16
