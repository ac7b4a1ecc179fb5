/* SPDX-License-Identifier: Apache-2.0 */
/* The program that the debuggers find: it does nothing, asleep. */
  .section .text.start, "ax"
  .globl _start
_start:
  wfi
  j _start
