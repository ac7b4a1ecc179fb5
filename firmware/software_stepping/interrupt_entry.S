# SPDX-License-Identifier: Apache-2.0
# The way from a tick that needs more than the short way to the function that attends to it.

# In: t0 = reason, t1 = return address. The interrupt has saved these two only as far as it uses
# registers itself; what the called function may change is saved here.
  .text
  .globl attend_saving_all
attend_saving_all:
  addi sp, sp, -64
  sw ra, 0(sp)
  sw t1, 4(sp)
  sw t2, 8(sp)
  sw a0, 12(sp)
  sw a1, 16(sp)
  sw a2, 20(sp)
  sw a3, 24(sp)
  sw a4, 28(sp)
  sw a5, 32(sp)
  sw a6, 36(sp)
  sw a7, 40(sp)
  sw t3, 44(sp)
  sw t4, 48(sp)
  sw t5, 52(sp)
  sw t6, 56(sp)
  mv a0, t0
  call attend_to_stepper
  lw ra, 0(sp)
  lw t1, 4(sp)
  lw t2, 8(sp)
  lw a0, 12(sp)
  lw a1, 16(sp)
  lw a2, 20(sp)
  lw a3, 24(sp)
  lw a4, 28(sp)
  lw a5, 32(sp)
  lw a6, 36(sp)
  lw a7, 40(sp)
  lw t3, 44(sp)
  lw t4, 48(sp)
  lw t5, 52(sp)
  lw t6, 56(sp)
  addi sp, sp, 64
  jr t1
