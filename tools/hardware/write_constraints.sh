#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints a board's pin constraints for nextpnr-ecp5: where each port of its top entity lies, out of boards/BOARD, and what
# its signal needs there, out of constraints/signals.csv. Ends with status 1 where something is missing or said twice.
# Usage: write_constraints.sh PROJECT BOARD
set -euo pipefail
project=$1 board=$2

awk -F, '
  function fail(text) { print "constraints of " FILENAME ": " text > "/dev/stderr"; failed = 1; exit 1 }
  function one_of(value, choices) { return index(" " choices " ", " " value " ") > 0 }
  function standard(volts) { if (volts != "3.3") fail("no I/O standard for " volts " V"); return "LVCMOS33" }
  FNR == 1 { file += 1; next }
  file == 1 {
    if ($1 in pull) fail("two rows for " $1)
    if (NF != 10) fail("10 columns are wanted for " $1)
    if (!one_of($2, "in out") || !one_of($3, "none up down") || $7 == "") fail("what does " $1 " need?")
    if ($2 == "in" ? $4 $5 != "" : !one_of($4, "4 8 12 16") || !one_of($5, "slow fast"))
      fail("drive and slew are for outputs, and for all of them: " $1)
    if ($6 != "" && ($6 != "pad" || $2 != "out")) fail("a register is in the pad of an output: " $1)
    pull[$1] = $3; drive[$1] = $4; slew[$1] = $5; volts[$1] = $7
    next
  }
  file == 2 { bank_volts[$1] = $2; next }
  file == 3 { if ($1 in pin) fail("two rows for " $1); pin[$1] = $2; bank[$1] = $4; next }
  {
    signal = $1
    sub(/\[.*/, "", signal)
    if (!(signal in pull)) fail("constraints/signals.csv does not say what " signal " needs")
    if (!($2 in pin)) fail("no pin for " $2)
    if ($1 in seen) fail($1 " is connected twice")
    if (pin[$2] in user) fail($1 " and " user[pin[$2]] " share a pin")
    seen[$1] = 1; user[pin[$2]] = $1
    if (bank_volts[bank[$2]] != volts[signal])
      fail($1 " needs " volts[signal] " V, bank " bank[$2] " has " bank_volts[bank[$2]])
    print "LOCATE COMP \"" $1 "\" SITE \"" pin[$2] "\";"
    line = "IOBUF PORT \"" $1 "\" IO_TYPE=" standard(volts[signal]) " PULLMODE=" toupper(pull[signal])
    if (drive[signal] != "") line = line " DRIVE=" drive[signal] " SLEWRATE=" toupper(slew[signal])
    print line ";"
  }
  END { exit failed }
' "$project/constraints/signals.csv" "$project/boards/$board/banks.csv" "$project/boards/$board/pins.csv" \
  "$project/boards/$board/connections.csv"
