#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints a board's timing constraints for Quartus: its clocks, out of constraints/BOARD.sdc, and the longest times between
# pins and registers, out of constraints/delays.csv, for each port. Usage: write_delays.sh PROJECT BOARD
set -euo pipefail
project=$1 board=$2

cat "$project/constraints/$board.sdc"
echo "# From constraints/delays.csv."
awk -F, '
  FNR == 1 { file += 1; next }
  file == 1 { longest[$1] = $2; next }
  file == 2 { direction[$1] = $2; next }
  {
    signal = $1
    sub(/\[.*/, "", signal)
    # A clock has its period.
    if (signal ~ /^clock_/) next
    if (direction[signal] == "in") from = "[get_ports {" $1 "}] -to [all_registers] " longest["input_to_register"]
    else from = "[all_registers] -to [get_ports {" $1 "}] " longest["register_to_output"]
    print "set_max_delay -from " from
  }
' "$project/constraints/delays.csv" "$project/constraints/signals.csv" "$project/boards/$board/connections.csv"
