# SPDX-License-Identifier: Apache-2.0
# Start-up of a C program: stack, zeroed variables, main; what main returns is not looked at.
  .section .text.start, "ax"
  .globl _start
_start:
  la sp, stack_top
  la a0, bss_begin
  la a1, bss_end
1:
  bgeu a0, a1, 2f
  sw zero, 0(a0)
  addi a0, a0, 4
  j 1b
2:
  call main
3:
  wfi
  j 3b
