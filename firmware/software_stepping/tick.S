# SPDX-License-Identifier: Apache-2.0
# A tick in the timer interrupt, in as few clocks as possible. All code of the image leaves these
# registers alone (../target): no tick saves any.
#include "software_stepping/tick_names.inc"

  .section .text.tick, "ax"
# Nothing outside of this code touches the registers above (tests/software_stepping/reserved_registers.sh).
  .globl tick_code_begins, tick_code_ends
tick_code_begins:

# The processor enters at the trap base for exceptions and 28 bytes after it for the timer, its only
# interrupt: what lies between is room for a tick that is late. The name of the base is \name.
.macro trap_base name
  .balign 4
  .globl \name
\name:
  .option push
  .option norvc
  j trap
  .option pop
.endm
.macro timer_entry name
  .org \name + 28
.endm

# An axis steps where its error term reaches 0; 4 clocks in both cases. `scratch` has its steps, `other`
# the ticks of the line; meanwhile `scratch` gets what follows.
.macro follow error, next:vararg
  add \error, \error, scratch
  lw scratch, \next
  bltz \error, 1f
  or pins, pins, \error
  sub \error, \error, other
1:
.endm

.macro next_pins followers
  lw pins, LEADER
  .if \followers == 0
    lw scratch, INTERVAL_FRACTION
  .else
    lw scratch, STEPS_1
    lw other, LINE_TICKS
  .endif
  .if \followers >= 2
    follow error_1, STEPS_2
  .endif
  .if \followers == 2
    follow error_2, INTERVAL_FRACTION
  .endif
  .if \followers >= 3
    follow error_2, STEPS_3
  .endif
  .if \followers == 3
    follow error_3, INTERVAL_FRACTION
  .endif
.endm

# Ticks at a constant rate, and what every tick does after its edge.
.macro ticks_of followers
  trap_base even_\followers
late_\followers:
  lw other, QUICK_BEHIND
  blt scratch, other, wait_or_give_up
  j tick_\followers
  timer_entry even_\followers
tick_\followers:
  sw pins, STEP
  addi left, left, -1
  beqz left, block_ends
  .globl rest_\followers
rest_\followers:
  next_pins \followers
  lw other, INTERVAL_CLOCKS
  add fraction, fraction, scratch
  sltu scratch, fraction, scratch
  add other, other, scratch
  add deadline, deadline, other
  lw scratch, PULSE_DELAY
  bltu deadline, other, carry_\followers
carried_\followers:
  bnez scratch, hold_pulse_\followers
end_pulse_\followers:
  csrr scratch, mcycle
  sw zero, STEP
  lw other, NEAR_CLOCKS
  sub scratch, deadline, scratch
  blt scratch, other, late_\followers
  lw scratch, deadline_high
  lui other, TIMER_UPPER
  sw deadline, COMPARE_LOW
  sw scratch, COMPARE_HIGH
  mret
hold_pulse_\followers:
  addi scratch, scratch, -1
  bnez scratch, hold_pulse_\followers
  j end_pulse_\followers
carry_\followers:
  lw other, deadline_high
  addi other, other, 1
  sw other, deadline_high, scratch
  lw scratch, PULSE_DELAY
  j carried_\followers
.endm

  ticks_of 0
  ticks_of 2
  ticks_of 3

# The guard, or a deadline that is nearer than it takes to leave and come back. In: `scratch` = clocks to
# the deadline, at the end of the pulse.
wait_or_give_up:
  lw other, INTERVAL_CLOCKS
  add other, other, scratch
  bltz other, give_up
  lw other, NEAR_CLOCKS
  bge scratch, other, 1f
  mv scratch, other
1:
  # So many clocks pass anyway.
  addi scratch, scratch, -25
2:
  addi scratch, scratch, -3
  bgez scratch, 2b
  lw other, TICK
  jr other
give_up:
  li scratch, LATE
  j attend

# The next interval of a ramp: advance_short_interval() of interval.hpp.
  trap_base ramp
  timer_entry ramp
tick_ramp:
  sw pins, STEP
  addi left, left, -1
  beqz left, block_ends
  lw scratch, INTERVAL
  sw t0, -4(sp)
  sw t1, -8(sp)
  mulh t0, scratch, scratch
  lw other, MANTISSA
  lw t1, LARGEST_CHANGE
  mulh t0, other, t0
  slli other, t1, 1
  add t1, t0, t1
  bgeu t1, other, interval_too_long
  lw other, SHIFT
  # Where the change is below 2^-17, its square adds nothing.
  lui t1, 8
  sll t0, t0, other
  add t1, t0, t1
  srli t1, t1, 16
  beqz t1, 1f
  mulh t1, t0, t0
  nop
  mulh other, t1, t0
  sub t0, t0, t1
  srai t1, t1, 1
  sub t0, t0, t1
  slli t1, other, 1
  add t0, t0, t1
  add t0, t0, other
  srai other, other, 2
  sub t0, t0, other
1:
  mulh t0, t0, scratch
  lui t1, 0x20000
  sub scratch, scratch, t0
  bgeu scratch, t1, interval_too_long
  sw scratch, INTERVAL
  srli other, scratch, 16
  sw other, INTERVAL_CLOCKS
  slli scratch, scratch, 16
  sw scratch, INTERVAL_FRACTION
  lw other, REST
  lw t1, -8(sp)
  lw t0, -4(sp)
  jr other
interval_too_long:
  lw t1, -8(sp)
  lw t0, -4(sp)
  li scratch, INTERVAL_TOO_LONG
  j end_pulse_and_attend

# A tick of a segment that end stops may end: none is made where one is triggered.
  trap_base watched
  timer_entry watched
  lui other, END_STOPS_UPPER
  lw scratch, END_STOPS
  lw other, STOP_MASK
  nop
  and scratch, scratch, other
  lw other, WATCHED_TICK
  bnez scratch, 1f
  jr other
1:
  li scratch, CAREFUL
  j attend

# The next block, where it is one for this way.
block_ends:
  lw other, NEXT
  nop
  lw scratch, TRAP_BASE(other)
  nop
  beqz scratch, 9f
  sw zero, TRAP_BASE(block)
  csrw mtvec, scratch
  mv block, other
  sw other, tick_block, scratch
  lw scratch, BEGINS_LINE
  lw left, TICKS
  lw other, REST
  beqz scratch, 2f
  lw scratch, HOLD_DELAY
  lw error_1, ERROR_1
  lw error_2, ERROR_2
  lw error_3, ERROR_3
  beqz scratch, 4f
1:
  addi scratch, scratch, -1
  bnez scratch, 1b
4:
  lw scratch, DIRECTION
  nop
  sw scratch, DIRECTION_PINS
2:
  jr other
9:
  li scratch, BLOCK_ENDS

#include "software_stepping/tick_attend.inc"

tick_code_ends:

# Ways of block.hpp.
  .section .rodata.ways, "a"
  .balign 4
  .globl tick_ways
tick_ways:
  .word careful + 1, watched + 1, ramp + 1
  .word even_0 + 1, even_2 + 1, even_2 + 1, even_3 + 1
  .word rest_0, rest_2, rest_2, rest_3
