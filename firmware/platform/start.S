# SPDX-License-Identifier: Apache-2.0
# What happens before main and when the processor traps: stack, memory, and the vector table.

  .section .text.start, "ax"
  .globl _start
_start:
  .option push
  .option norelax
  la gp, __global_pointer$
  .option pop
  csrw mie, zero
  csrci mstatus, 8
  la t0, vector_table
  ori t0, t0, 1
  csrw mtvec, t0

  # The stack is painted, so that its peak can be read from memory afterwards.
  la sp, _stack_top
  la t0, _stack_bottom
  li t1, 0xA5A5A5A5
1:
  sw t1, 0(t0)
  addi t0, t0, 4
  bltu t0, sp, 1b

  la t0, _bss_start
  la t1, _bss_end
  j 3f
2:
  sw zero, 0(t0)
  addi t0, t0, 4
3:
  bltu t0, t1, 2b

  call main
  # main does not return; if it does, that is a fault like any other.
  ebreak

# Vectored traps: entry 0 is for exceptions, entry n for interrupt n; each is a word. The tasks run with
# interrupts disabled and use them to end wfi only, so none of them is expected either. The image that
# makes the steps in software has vectors of its own for the timer.
  # Its alignment must not move _start.
  .section .text.vectors, "ax"
  .balign 128
  .globl vector_table
vector_table:
  .option push
  .option norvc
  .rept 32
  j trap
  .endr
  .option pop

# A trap is the end: the report gets a whole stack, because the old one may be what is broken.
  .globl trap
trap:
  mv a3, sp
  mv a4, ra
  la sp, _stack_top
  csrr a0, mcause
  csrr a1, mepc
  csrr a2, mtval
  j report_trap
