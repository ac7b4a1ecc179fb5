# SPDX-License-Identifier: Apache-2.0
# Interrupts: masks, order, vectors, return, and wfi.
  .include "check.inc"
  .equ timer, 7
  .equ external, 11

# All requests of `mask` at once; s5 collects the causes in the order in which they were taken.
  .macro request mask
  li s5, 0
  li t0, \mask
  li t1, interrupt_requests
  sw t0, 0(t1)
  nop
  nop
  nop
  nop
  .endm

  begin
  la t0, handler
  csrw mtvec, t0
  li s10, interrupt_requests
  li a0, -1
  csrw mie, a0
  csrsi mstatus, 8

  request 1 << timer
  check s5, timer
  request 1 << external
  check s5, external
  request 1 << 16
  check s5, 16
  request 1 << 31
  check s5, 31
  # External before timer before 16 before 17.
  request 1 << external | 1 << timer | 1 << 16 | 1 << 17
  check s5, external << 24 | timer << 16 | 16 << 8 | 17
  request 1 << 31 | 1 << 18 | 1 << 30
  check s5, 18 << 16 | 30 << 8 | 31

  # Not enabled by mie, then not by mstatus.
  li a0, 1 << 20
  csrw mie, a0
  request 1 << 21
  check s5, 0
  csrr a0, mip
  check a0, 1 << 21
  request 1 << 20 | 1 << 21
  check s5, 20
  csrci mstatus, 8
  request 1 << 20
  check s5, 0
  # At once when allowed; and not any more after the instruction that forbids.
  csrsi mstatus, 8
  nop
  check s5, 20
  request 0
  csrci mstatus, 8
  request 1 << 20
  csrsi mstatus, 8
  csrci mstatus, 8
  nop
  nop
  check s5, 20
  csrsi mstatus, 8

  # In each instruction of a loop with division, bus access and jumps, 64 times.
  li s6, 64
  li s7, 0
1:
  li t0, 1 << 20
  sw t0, 0(s10)
  div a0, s6, s6
  lw a1, 0(s10)
  add s7, s7, a0
  addi s6, s6, -1
  bnez s6, 1b
  check s7, 64

  # Vectored: interrupts to base + 4 * cause, exceptions to the base.
  la t0, vectors + 1
  csrw mtvec, t0
  li s8, 0
  request 1 << 20
  check s8, 20
  li a0, 1 << 31
  csrw mie, a0
  request 1 << 31
  check s8, 31
  ecall
  check s8, 100
  la t0, handler
  csrw mtvec, t0

  # wfi waits for what mie lets through, also where mstatus forbids, and goes on after itself.
  li a0, 1 << 20
  csrw mie, a0
  csrci mstatus, 8
  request 1 << 20
  wfi
  check s5, 0
  csrsi mstatus, 8
  nop
  check s5, 20
  # The request comes from outside while it sleeps: see the test.
  li s5, 0
  li t0, 0x51ee9
  sw t0, -256(s10)
wait:
  wfi
after_wait:
  check s5, 20
  check_address s9, after_wait
  j done

# Direct: notes the cause and takes this one request back; the last instruction sees it gone.
  .align 2
handler:
  csrr t2, mcause
  bgez t2, failed
  andi t2, t2, 31
  slli s5, s5, 8
  or s5, s5, t2
  li t3, 1
  sll t3, t3, t2
  lw t4, 0(s10)
  not t3, t3
  and t4, t4, t3
  sw t4, 0(s10)
  csrr s9, mepc
  mret

  .align 7
vectors:
  j exception
  .rept 19
  j failed
  .endr
  j vector_20
  .rept 10
  j failed
  .endr
vector_31:
  li s8, 31
  sw zero, 0(s10)
  mret
vector_20:
  li s8, 20
  sw zero, 0(s10)
  mret
exception:
  li s8, 100
  csrr t0, mepc
  addi t0, t0, 4
  csrw mepc, t0
  mret
done:
  end
