# SPDX-License-Identifier: Apache-2.0
# The loader's two ways in, what it knows of the program, and a fresh start after a trap of its own.

  .section .text.start, "ax"
  .option norvc
  .globl _start
_start:
  j from_reset
  j from_request
  # By which programs know that the loader is here (platform/boot_loader.cpp).
  .word 0x6C4F6642
  # Where the program begins that may be started; 0 while there is none. Kept over a reset, as all memory is.
  .globl program_entry
program_entry:
  .word 0x80000008
  .option rvc

from_reset:
  li a0, 0
  j begin
  .balign 4
from_request:
  li a0, 1
begin:
  csrw mie, zero
  csrci mstatus, 8
  la t0, from_request
  csrw mtvec, t0
  la sp, _stack_top
  call load_or_pass
  # What was written is code now.
  .option push
  .option arch, +zifencei
  fence.i
  .option pop
  jr a0
