# SPDX-License-Identifier: Apache-2.0
# The word that the simulation watches.
  .section .tohost, "aw"
  .globl tohost
  .align 6
tohost:
  .word 0
  .globl fromhost
  .align 6
fromhost:
  .word 0
