# SPDX-License-Identifier: Apache-2.0
# Loads and stores of each size at each place, in memory and on the bus, and jumps and branches.
  .include "check.inc"

  .macro all_sizes
  li t0, 0x81828384
  sw t0, 0(s0)
  lw a0, 0(s0)
  check a0, 0x81828384
  lb a0, 0(s0)
  check a0, 0xffffff84
  lb a0, 1(s0)
  check a0, 0xffffff83
  lb a0, 2(s0)
  check a0, 0xffffff82
  lb a0, 3(s0)
  check a0, 0xffffff81
  lbu a0, 0(s0)
  check a0, 0x84
  lbu a0, 3(s0)
  check a0, 0x81
  lh a0, 0(s0)
  check a0, 0xffff8384
  lh a0, 2(s0)
  check a0, 0xffff8182
  lhu a0, 0(s0)
  check a0, 0x8384
  lhu a0, 2(s0)
  check a0, 0x8182
  li t0, 0xffffff11
  sb t0, 0(s0)
  li t0, 0xffffff22
  sb t0, 1(s0)
  lw a0, 0(s0)
  check a0, 0x81822211
  li t0, 0xffffff33
  sb t0, 2(s0)
  li t0, 0xffffff44
  sb t0, 3(s0)
  lw a0, 0(s0)
  check a0, 0x44332211
  li t0, 0xffff5566
  sh t0, 2(s0)
  lw a0, 0(s0)
  check a0, 0x55662211
  li t0, 0xffff7788
  sh t0, 0(s0)
  lw a0, 0(s0)
  check a0, 0x55667788
  .endm

# The branch `name` between the two numbers is taken (1) or not (0).
  .macro branch name, first, second, taken
  li a0, \first
  li a1, \second
  li a2, 1
  \name a0, a1, 1f
  li a2, 0
1:
  check a2, \taken
  .endm

  begin
  la s0, place
  all_sizes
  li s0, device + 0x20
  all_sizes

  # A loaded pointer is used at once, a loaded value is stored at once.
  la s0, place
  sw s0, 4(s0)
  lw s1, 4(s0)
  lw s2, 4(s1)
  sw s2, 8(s2)
  lw a0, 8(s0)
  check_address a0, place

  branch beq, 5, 5, 1
  branch beq, 5, 0x80000005, 0
  branch bne, 5, 5, 0
  branch bne, 5, 4, 1
  branch blt, 0x80000000, 0x7fffffff, 1
  branch blt, 0x7fffffff, 0x80000000, 0
  branch blt, 3, 3, 0
  branch bge, 0x80000000, 0x7fffffff, 0
  branch bge, 3, 3, 1
  branch bltu, 0x80000000, 0x7fffffff, 0
  branch bltu, 0x7fffffff, 0x80000000, 1
  branch bgeu, 0xffffffff, 0, 1
  branch bgeu, 0, 1, 0

  # Backward branches, calls and returns.
  li a0, 0
  li a1, 10
1:
  add a0, a0, a1
  addi a1, a1, -1
  bnez a1, 1b
  check a0, 55
  jal ra, function
back:
  check a0, 77
  la t0, function + 1
  jalr ra, 0(t0)
  check_address t1, after
after:
  # The instruction after a store to it is the new one after fence.i.
  la t0, changed
  li t1, 0x05800513
  sw t1, 0(t0)
  fence.i
changed:
  li a0, 1
  check a0, 88
  j done

function:
  li a0, 77
  la t1, after
  ret

done:
  end

  .data
  .align 2
place:
  .space 16
