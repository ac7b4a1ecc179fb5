#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Each program does the same in the same clocks in GHDL, which runs the sources, and in the Verilated netlist.
# Usage: compare_with_ghdl.sh PROJECT WORK_DIRECTORY TRACE_PROGRAM PROGRAMS_DIRECTORY HAS_ZBB NAME...
set -euo pipefail
project=$1 work=$2 trace_program=$3 programs=$4 has_zbb=$5
shift 5
failures=0
# Fewer lines than this means that the comparison did not take place.
least_lines=100

rm -rf "$work"
mkdir -p "$work/library"
options=(--std=08 -fpsl --workdir="$work/library")
"$project/tools/hardware/weave_properties.sh" "$project/rtl" "$project/testbench/proofs" \
  "$work/rtl" simulation
mapfile -t files < <(find "$work/rtl" "$project/testbench" -name '*.vhd' | sort)
ghdl -i "${options[@]}" "${files[@]}"
ghdl -m "${options[@]}" processor_trace > "$work/make.log" || { cat "$work/make.log"; exit 1; }
cd "$work"

for name in "$@"; do
  tohost=$(sed -n 's/^\([0-9a-f]*\) . tohost$/\1/p' "$programs/$name.symbols")
  generics=("-gprogram_file=$programs/$name.bin" "-gtrace_file=$name.ghdl"
    "-gtohost_offset=$((16#$tohost - 16#80000000))" "-ghas_zbb=$has_zbb")
  ghdl -r "${options[@]}" processor_trace "${generics[@]}" --assert-level=error > "$name.log" 2>&1 ||
    { cat "$name.log"; failures=$((failures + 1)); continue; }
  "$trace_program" "$name" "$name.netlist"
  lines=$(wc -l < "$name.ghdl")
  if [ "$lines" -lt "$least_lines" ] || ! cmp "$name.ghdl" "$name.netlist"; then
    echo "$name: $lines instructions in GHDL; the first that differ:"
    diff "$name.ghdl" "$name.netlist" | head -n 6
    failures=$((failures + 1))
  else
    clocks=$(tail -n 1 "$name.ghdl" | cut -d ' ' -f 1)
    echo "$name: the same $lines instructions and traps in the same $clocks clocks"
  fi
done
[ "$failures" = 0 ]
