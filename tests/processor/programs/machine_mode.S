# SPDX-License-Identifier: Apache-2.0
# What the field's tests of machine mode demand, in our words: fetches at half words, illegal instructions,
# breakpoints, misaligned accesses, registers that may be missing, counters, instructions that are written.
  .include "environment.inc"

# The instruction traps and is left out: s1 has its cause, s2 mepc, s3 mtval.
  .macro refused cause, instruction:vararg
  li s1, -1
  la s4, 1f
1:
  \instruction
  check s1, \cause
  sub s5, s2, s4
  check s5, 0
  .endm

# mtval of an illegal instruction: 0, or its bits.
  .macro illegal word
  refused 2, .word \word
  beqz s3, 1f
  check s3, \word
1:
  .endm

  .macro misaligned cause, operation, offset
  refused \cause, \operation x0, \offset(s0)
  addi s5, s0, \offset
  sub s5, s5, s3
  check s5, 0
  .endm

  enter
  csrr a0, mstatus
  check a0, 0x1880

  # A jump to the second half of a word is no trap; bit 0 of a target is ignored; the link is right.
  la t0, 2f
  jalr t1, 2(t0)
2:
  .option rvc
  c.j jumped_wrong
  c.j 3f
jumped_wrong:
  .option norvc
  j failed
3:
  sub t1, t1, t0
  check t1, 0
  la t0, 2f
  jalr t1, 1(t0)
2:
  j 3f
  j failed
3:
  la t0, 2f
  jalr t1, 3(t0)
2:
  .option rvc
  c.j jumped_wrong
  c.j 3f
  .option norvc
  j failed
3:

  # No instruction; shifts by 32 and more; what no processor without these extensions has.
  illegal 0x02051513
  illegal 0x02055513
  illegal 0x42055513
  illegal 0xffffffff
  illegal 0x100522af  # lr.w
  illegal 0x00052507  # flw
  illegal 0x12000073  # sfence.vma
  illegal 0x10200073  # sret
  li a0, 1
  slli a0, a0, 16
  check a0, 65536
  li s1, -1
zero_word:
  .word 0
  check s1, 2
  check_address s2, zero_word
  check s3, 0

  # Registers of supervisor mode, of user mode's counters' permission, of delegation and of protection.
  .irp name, sscratch, stvec, satp, medeleg, mideleg, mcounteren, pmpcfg0, pmpaddr0, menvcfg, dcsr, time
  refused 2, csrr a0, \name
  .endr
  .irp name, cycle, instret, cycleh, instreth, mhartid, mvendorid, marchid, mimpid, mconfigptr
  refused 2, csrwi \name, 0
  refused 2, csrrw zero, \name, zero
  refused 2, csrsi \name, 1
  # Not a write.
  csrsi \name, 0
  csrci \name, 0
  csrs \name, zero
  csrc \name, zero
  csrr zero, \name
  .endr

  # There is no other mode, and no way to switch the short instructions off.
  li a0, 3 << 11
  csrc mstatus, a0
  csrr a1, mstatus
  and a1, a1, a0
  check a1, 3 << 11
  li a0, 1 << 11
  csrw mstatus, a0
  csrr a1, mstatus
  check a1, 0x1800
  la t0, 1f
  csrw mepc, t0
  mret
1:
  csrr a0, misa
  srli a1, a0, 30
  check a1, 1
  li t0, 1 << 2 | 1 << 18 | 1 << 20
  and a1, a0, t0
  check a1, 1 << 2
  csrci misa, 1 << 2
  csrr a1, misa
  sub a1, a1, a0
  check a1, 0
  csrr a0, mhartid
  check a0, 0
  csrs mtvec, zero
  csrs mepc, zero

  # No trigger: the selection does not take, and there is nothing of a kind that could be set. A program
  # may write the address before it looks at the kind: that is no trap.
  li a0, 1 << 31
  csrw tselect, a0
  csrr a1, tselect
  check a1, 0
  la a0, place
  csrw tdata2, a0
  csrr a1, tdata2
  check a1, 0
  li a0, 0x20000044
  csrw tdata1, a0
  csrr a1, tdata1
  srli a1, a1, 28
  check a1, 0

  refused 3, ebreak
  sub s5, s3, s4
  check s5, 0

  # Misaligned, also where the register is x0; nothing is stored.
  la s0, place
  .irp offset, 1, 3
  misaligned 4, lh, \offset
  misaligned 4, lhu, \offset
  .endr
  .irp offset, 1, 2, 3
  misaligned 4, lw, \offset
  misaligned 6, sw, \offset
  .endr
  misaligned 6, sh, 1
  misaligned 6, sh, 3
  lw a0, 0(s0)
  check a0, 0x04030201
  lw a0, 4(s0)
  check a0, 0x08070605
  # Where nothing is.
  li s0, 0x40000000
  refused 5, lw a0, 0(s0)
  check s3, 0x40000000
  refused 7, sb a0, 1(s0)
  check s3, 0x40000001

  # Set, clear and write of a register give its old value.
  csrwi mscratch, 3
  csrrci a0, mscratch, 1
  check a0, 3
  csrrsi a0, mscratch, 4
  check a0, 2
  csrrwi a0, mscratch, 2
  check a0, 6
  li a0, 0xbad1dea
  csrrw a0, mscratch, a0
  check a0, 2
  li a0, 0x1dea
  csrrc a0, mscratch, a0
  check a0, 0xbad1dea
  li a0, 0xbeef
  csrrs a0, mscratch, a0
  check a0, 0xbad0000
  csrr a0, mscratch
  check a0, 0xbadbeef

  # What is written to minstret is what the next instruction reads; it carries into its upper half.
  csrwi minstret, 0
  csrr a0, minstret
  check a0, 0
  li a0, -1
  csrw minstret, a0
  csrw minstreth, a0
  nop
  csrr a0, minstret
  check a0, 0
  csrr a0, minstreth
  check a0, 0

  # An instruction that is written and then run; one that has been run before it was written.
  la a0, adds_5
  lw a0, 0(a0)
  la a1, 1f
  sw a0, 0(a1)
  li a2, 100
  fence.i
1:
  addi a2, a2, 1
  check a2, 105
  la a1, 2f
  li a2, 0
  li a3, 3
2:
  addi a2, a2, 1
  addi a3, a3, -1
  bnez a3, 2b
  bnez a4, 3f
  li a4, 1
  li a3, 2
  sw a0, 0(a1)
  fence.i
  j 2b
3:
  check a2, 13

  # One instruction on two pages.
  li a2, 0
  j crossing
  .balign 4096
  .skip 4094, 0
crossing:
  addi a2, a2, 1
  check a2, 1
  leave

# Notes the trap and leaves the instruction out.
own_handler:
  csrr s1, mcause
  csrr s2, mepc
  csrr s3, mtval
  addi t1, s2, 4
  csrw mepc, t1
  mret

adds_5:
  addi a2, a2, 5

  .data
  .balign 4
place:
  .word 0x04030201, 0x08070605
