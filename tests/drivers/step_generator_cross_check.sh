#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Executes the same random segments in the VHDL (GHDL) and in the Verilated netlist; the edges of all pins
# must be the same in every clock. Usage: step_generator_cross_check.sh PROGRAM PROJECT DIRECTORY SEED...
set -euo pipefail
program=$1 project=$2 directory=$3
shift 3
segments=150
watched_clocks=50000
mkdir -p "$directory"
for seed in "$@"; do
  stimuli=$directory/stimuli_$seed.txt
  netlist=$directory/netlist_$seed.txt
  vhdl=$directory/vhdl_$seed.txt
  clocks=$("$program" "$seed" "$segments" "$stimuli" "$netlist")
  # The properties watch the short runs only: they take three quarters of the time, and all benches of
  # the generator have them, too.
  options=()
  [ "$clocks" -lt "$watched_clocks" ] || options=(--without-properties)
  "$project/tools/hardware/run_testbench.sh" "${options[@]}" "$directory/work" step_generator_replay "$project" \
    "-gstimuli_file=$stimuli" "-gedges_file=$vhdl" "-gclocks=$clocks"
  edges=$(wc -l < "$netlist")
  [ "$edges" -gt 100 ] || { echo "seed $seed: only $edges edges"; exit 1; }
  cmp "$vhdl" "$netlist" || { diff "$vhdl" "$netlist" | head; exit 1; }
  echo "seed $seed: $edges edges in $clocks clocks, the same in VHDL and netlist"
done
