# SPDX-License-Identifier: Apache-2.0
# Where the processor begins after a reset in an image with the boot loader: the loader first, which passes
# on to _start after this.
  .section .text.reset, "ax"
  .option norvc
  .globl reset
reset:
  lui t0, %hi(_boot_loader)
  jalr zero, %lo(_boot_loader)(t0)

# The loader itself, linked to the place where the linker script puts this.
  .section .boot_loader, "ax"
  .incbin "loader_image.bin"
