# SPDX-License-Identifier: Apache-2.0
# Initial contents that show which block RAM holds which bit of a word: word k is bit k alone.

  .globl _start
_start:
  .set bit, 0
  .rept 32
  .word 1 << bit
  .set bit, bit + 1
  .endr
