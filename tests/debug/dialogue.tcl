# SPDX-License-Identifier: Apache-2.0
# What a person does with OpenOCD, and the expected results. Set before: program, and the addresses loop,
# counted, counter and stop of its symbols.

proc fail {what} {
  echo "FAILED: $what"
  shutdown error
}

proc expect {what found wanted} {
  if {$found != $wanted} { fail [format "%s is 0x%x instead of 0x%x" $what $found $wanted] }
}

proc register {name} { return [dict get [stepfabric.cpu get_reg -force $name] $name] }
proc word {address} { return [lindex [read_memory $address 32 1] 0] }

proc expect_state {wanted} {
  stepfabric.cpu arp_poll
  if {[stepfabric.cpu curstate] != $wanted} { fail "the state is [stepfabric.cpu curstate], not $wanted" }
}

init

# Halted out of sleep; registers and memory can be written.
halt
wait_halt 10000
expect_state halted
stepfabric.cpu set_reg {s3 0x89abcdef sp 0x8000fff0}
expect s3 [register s3] 0x89abcdef
expect sp [register sp] 0x8000fff0
stepfabric.cpu set_reg {mscratch 0x13572468}
expect mscratch [register mscratch] 0x13572468
expect misa [register misa] 0x40001104
write_memory 0x80008000 32 {0x11223344 0x55667788}
write_memory 0x80008001 8 0xaa
write_memory 0x80008006 16 0xbbcc
expect "first word" [word 0x80008000] 0x1122aa44
expect "second word" [word 0x80008004] 0xbbcc7788

# A program is loaded and runs from the reset on.
load_image $program
verify_image $program
reset halt
expect "pc after reset" [register pc] 0x80000000
expect "counter before" [word $counter] 0xffffffff

# A breakpoint in hardware, one in memory.
bp $counted 2 hw
resume
wait_halt 10000
expect "pc at breakpoint" [register pc] $counted
expect "counter at breakpoint" [word $counter] 0xffffffff
expect a0 [register a0] 1
rbp $counted
step
expect "counter after step" [word $counter] 1
bp $loop 2
resume
wait_halt 10000
expect "pc at second breakpoint" [register pc] $loop
# OpenOCD by itself does not go on from a breakpoint in memory that it stands on.
rbp $loop
step
bp $loop 2
resume
wait_halt 10000
expect "pc a round later" [register pc] $loop
expect "a0 a round later" [register a0] 2
rbp $loop

# Steps go through the loop.
for {set round 3} {$round < 6} {incr round} {
  step
  expect "a0 stepped" [register a0] $round
  step
  expect "pc stepped" [register pc] $counted
  step
  step
  step
  expect "counter stepped" [word $counter] $round
  expect "pc back" [register pc] $loop
}

# Memory is read while the program runs.
resume
expect_state running
set earlier [word $counter]
if {[word $counter] <= $earlier} { fail "the program does not count" }
expect_state running

# An ebreak of the program's own.
halt
wait_halt 10000
resume $stop
wait_halt 10000
expect "pc at ebreak" [register pc] $stop

# Reset and run.
reset run
expect_state running
write_memory $counter 32 0
set earlier [word $counter]
if {[word $counter] <= $earlier} { fail "the program does not run after a reset" }
echo "PASSED"
shutdown
