#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints a board's pin constraints: where each port of its top entity lies, out of boards/BOARD, and what its signal needs
# there, out of constraints/signals.csv. For nextpnr-ecp5, or, of a board with a device.csv, as Tcl for Quartus. Ends with
# status 1 where something is missing, said twice or not possible. Usage: write_constraints.sh PROJECT BOARD
set -euo pipefail
project=$1 board=$2
folder=$project/boards/$board

tool=nextpnr family=ECP5
if [ -f "$folder/device.csv" ]; then
  tool=quartus family=$(awk -F, '$1 == "family" { print $2 }' "$folder/device.csv")
fi

awk -F, -v tool=$tool -v family="$family" '
  function fail(text) { print "constraints of " FILENAME ": " text > "/dev/stderr"; failed = 1; exit 1 }
  function one_of(value, choices) { return index(" " choices " ", " " value " ") > 0 }
  function standard(volts) {
    if (tool == "nextpnr" && volts == "3.3") return "LVCMOS33"
    if (tool == "quartus" && volts == "3.3") return "3.3-V LVTTL"
    if (tool == "quartus" && volts == "2.5") return "2.5 V"
    fail("no I/O standard for " volts " V")
  }
  # In braces, because Tcl reads led[0] as a call of 0.
  function assign(name, value) {
    print "set_instance_assignment -name " name " \"" value "\" -to {" $1 "}"
  }
  # Cyclones pull up only, and change no slew at 3.3 V. An output is always driven: it needs no pull.
  function write_for_quartus(signal, volts) {
    if (dir[signal] == "in" && pull[signal] == "down") fail("a " family " has no pull-down for " $1)
    if (family == "Cyclone IV E" && volts == "3.3" && !one_of(drive[signal], "4 8") && dir[signal] == "out")
      fail("no " drive[signal] " mA at " volts " V for " $1)
    if (io[$2] != standard(volts))
      fail($2 " is " io[$2] " in the table, but in bank " bank[$2] " of " volts " V")
    print "set_location_assignment PIN_" pin[$2] " -to {" $1 "}"
    assign("IO_STANDARD", standard(volts))
    if (dir[signal] == "in" && pull[signal] == "up") assign("WEAK_PULL_UP_RESISTOR", "ON")
    if (drive[signal] != "") assign("CURRENT_STRENGTH_NEW", drive[signal] "MA")
    if (registered[signal] == "pad") assign("FAST_OUTPUT_REGISTER", "ON")
  }
  function write_for_nextpnr(signal, volts, line) {
    print "LOCATE COMP \"" $1 "\" SITE \"" pin[$2] "\";"
    line = "IOBUF PORT \"" $1 "\" IO_TYPE=" standard(volts) " PULLMODE=" toupper(pull[signal])
    if (drive[signal] != "") line = line " DRIVE=" drive[signal] " SLEWRATE=" toupper(slew[signal])
    print line ";"
  }
  FNR == 1 { file += 1; next }
  file == 1 {
    if ($1 in pull) fail("two rows for " $1)
    if (NF != 10) fail("10 columns are wanted for " $1)
    if (!one_of($2, "in out") || !one_of($3, "none up down") || $7 == "") fail("what does " $1 " need?")
    if ($2 == "in" ? $4 $5 != "" : !one_of($4, "4 8 12 16") || !one_of($5, "slow fast"))
      fail("drive and slew are for outputs, and for all of them: " $1)
    if ($6 != "" && ($6 != "pad" || $2 != "out")) fail("a register is in the pad of an output: " $1)
    dir[$1] = $2; pull[$1] = $3; drive[$1] = $4; slew[$1] = $5; registered[$1] = $6; volts[$1] = $7
    next
  }
  file == 2 { bank_volts[$1] = $2; next }
  file == 3 {
    if ($1 in pin) fail("two rows for " $1)
    pin[$1] = $2; io[$1] = $3; bank[$1] = $4; input_only[$1] = $5 == "clock_input"
    next
  }
  {
    signal = $1
    sub(/\[.*/, "", signal)
    if (!(signal in pull)) fail("constraints/signals.csv does not say what " signal " needs")
    if (!($2 in pin)) fail("no pin for " $2)
    if (!(bank[$2] in bank_volts)) fail("in which bank is " $2 "?")
    if ($1 in seen) fail($1 " is connected twice")
    if (pin[$2] in user) fail($1 " and " user[pin[$2]] " share a pin")
    if (input_only[$2] && (dir[signal] != "in" || pull[signal] != "none"))
      fail($2 " is a clock input: it drives nothing and has no pull for " $1)
    seen[$1] = 1; user[pin[$2]] = $1
    given = bank_volts[bank[$2]]
    if (volts[signal] != "any" && given != volts[signal])
      fail($1 " needs " volts[signal] " V, bank " bank[$2] " has " given)
    if (tool == "quartus") write_for_quartus(signal, given)
    else write_for_nextpnr(signal, given)
  }
  END { exit failed }
' "$project/constraints/signals.csv" "$folder/banks.csv" "$folder/pins.csv" "$folder/connections.csv"
