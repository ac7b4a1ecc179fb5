# SPDX-License-Identifier: Apache-2.0
# The firmware heats the hotend when it is halted: the hardware's watchdog switches the heater off, and tells it.

# rtl/registers/heater_control.md: channel 0 is the hotend.
set heater_control 0xf0006000
set duty [expr {$heater_control + 0x14}]
set status [expr {$heater_control + 0x44}]
set gate 0x1
set tripped 0x80
set watchdog_trip 0x100

proc fail {what} {
  echo "FAILED: $what"
  shutdown error
}

proc word {address} { return [lindex [read_memory $address 32 1] 0] }

# Until the expression is true; the simulation is slower than real time.
proc wait_until {what condition} {
  for {set tries 0} {$tries < 1200} {incr tries} {
    if {[uplevel 1 [list expr $condition]]} { return }
    sleep 100
  }
  fail "$what did not happen"
}

init
# Seen while the firmware runs.
wait_until "heating" {[word $duty] != 0 && ([word $status] & $gate) != 0}
if {([word $status] & $tripped) != 0} { fail "something has tripped before" }
halt
wait_halt 10000
if {[word $duty] == 0} { fail "the duty is gone" }
wait_until "the watchdog's trip" {([word $status] & $watchdog_trip) != 0}
if {([word $status] & ($gate | $tripped)) != $tripped} { fail "the gate is open" }
if {[stepfabric.cpu curstate] != "halted"} { fail "it is not halted any more" }
resume
sleep 500
if {([word $status] & ($gate | $tripped)) != $tripped} { fail "the gate opens again" }
echo "PASSED"
shutdown
