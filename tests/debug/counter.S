/* SPDX-License-Identifier: Apache-2.0 */
/* The program that the debuggers load: it counts forever, in a register and in memory. */
  .section .text.start, "ax"
  .globl _start, loop, counted, counter, stop
_start:
  li a0, 0
  la s0, counter
loop:
  addi a0, a0, 1
  jal counted
  j loop
counted:
  sw a0, 0(s0)
  ret
stop:
  ebreak
  j stop

  .data
counter:
  .word 0xffffffff
