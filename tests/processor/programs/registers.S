# SPDX-License-Identifier: Apache-2.0
# The control and status registers: what they hold after reset, keep, forbid, and count.
  .include "check.inc"

# All ones are written to the CSR; `kept` is what it has then. It is zero again afterwards.
  .macro keeps name, kept
  li a0, -1
  csrw \name, a0
  csrr a1, \name
  check a1, \kept
  csrw \name, zero
  csrr a1, \name
  .endm

  begin
  csrr a0, mstatus
  check a0, 0x1800
  csrr a0, mie
  check a0, 0
  csrr a0, mcause
  check a0, 0
  csrr a0, mcountinhibit
  check a0, 0
  csrr a0, misa
  check a0, 0x40001104
  csrw misa, zero
  csrr a0, misa
  check a0, 0x40001104
  csrr a0, mhartid
  check a0, 0
  csrr a0, mvendorid
  csrr a0, marchid
  csrr a0, mimpid
  csrr a0, mconfigptr
  csrr a0, mstatush
  check a0, 0

  keeps mscratch, 0xffffffff
  check a1, 0
  keeps mepc, 0xfffffffe
  check a1, 0
  keeps mcause, 0x8000001f
  check a1, 0
  keeps mtval, 0xffffffff
  check a1, 0
  keeps mie, 0xffff0880
  check a1, 0
  keeps mip, 0
  check a1, 0
  keeps mcountinhibit, 5
  check a1, 0
  keeps mhpmcounter3, 0
  check a1, 0
  keeps mhpmevent31, 0
  check a1, 0
  .irp name, tselect, tdata1, tdata2, tdata3
  keeps \name, 0
  check a1, 0
  .endr
  csrr s0, mtvec
  li a0, -1
  csrw mtvec, a0
  csrr a1, mtvec
  csrw mtvec, s0
  check a1, 0xfffffffd
  li a0, -1
  csrw mstatus, a0
  csrr a1, mstatus
  check a1, 0x1888
  csrci mstatus, 8
  csrr a1, mstatus
  check a1, 0x1880

  # Write, set and clear, with registers and constants; the old value comes back.
  csrwi mscratch, 21
  csrrsi a0, mscratch, 10
  check a0, 21
  csrrci a0, mscratch, 17
  check a0, 31
  li a1, 0xf0f0f0f0
  csrrw a0, mscratch, a1
  check a0, 14
  li a1, 0x0ff00ff0
  csrrs a0, mscratch, a1
  check a0, 0xf0f0f0f0
  csrrc a0, mscratch, a1
  check a0, 0xfff0fff0
  csrrw a0, mscratch, zero
  check a0, 0xf000f000
  csrrwi a0, mscratch, 0
  check a0, 0

  # mret: MIE from MPIE, MPIE set.
  li a0, 0x80
  csrw mstatus, a0
  la a0, 1f
  csrw mepc, a0
  mret
  j failed
1:
  csrr a0, mstatus
  check a0, 0x1888
  csrw mstatus, zero

  # mret to the middle of a word.
  la a0, 2f
  csrw mepc, a0
  li a1, 0
  mret
  .option rvc
  c.li a1, 1
2:
  c.addi a1, 2
  .option norvc
  .align 2
  check a1, 2

  # Instructions are counted; one that writes the counter is not.
  csrwi minstret, 0
  csrr a0, minstret
  check a0, 0
  nop
  nop
  csrr a0, instret
  csrr a1, minstret
  sub a1, a1, a0
  check a1, 1
  li t0, -1
  csrw minstret, t0
  csrw minstreth, t0
  nop
  csrr a0, minstret
  check a0, 0
  csrr a0, minstreth
  check a0, 0
  csrwi mcountinhibit, 4
  csrr a0, minstret
  nop
  csrr a1, minstret
  sub a1, a1, a0
  check a1, 0
  csrwi mcountinhibit, 0

  # Clocks are counted.
  csrwi mcycle, 0
  csrr a0, mcycle
  check a0, 0
  csrr a0, mcycle
  csrr a1, cycle
  sub a1, a1, a0
  check a1, 1
  csrwi mcountinhibit, 1
  csrr a0, mcycle
  nop
  csrr a1, mcycle
  sub a1, a1, a0
  check a1, 0
  csrwi mcountinhibit, 0
  csrwi mcycleh, 5
  csrr a0, cycleh
  check a0, 5
  end
