# SPDX-License-Identifier: Apache-2.0
# Start of the bare-metal test programs: a stack at the end of the memory.
  .section .init, "ax"
  .globl _start
_start:
  la sp, stack_top
  call main
