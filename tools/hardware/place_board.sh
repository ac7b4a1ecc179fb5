#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What synthesize_board.sh has left in NETLIST_DIRECTORY on an ECP5: netlist -> (nextpnr) -> layout.config ->
# (pack_bitstream.sh) -> bitstream with the firmware, with report.json in the directory, and in pins.json what the
# constraints ask of the pins' times. Usage: place_board.sh PROJECT BOARD NETLIST_DIRECTORY DEVICE SEED DIRECTORY FIRMWARE.elf
set -euo pipefail
project=$1 board=$2 netlist=$3/netlist.json contents=$3/contents.hex device=$4 seed=$5 directory=$6 firmware=$7

. "$project/tools/hardware/steps.sh"

# Timing-critical nets weigh more than total wire length (nextpnr's default is 10) and are routed a second time.
timing=(--placer-heap-timingweight 80 --post-route "$project/tools/hardware/place_critical.py" --timing-allow-fail)
export PYTHONPATH=$project/tools/hardware PYTHONDONTWRITEBYTECODE=1

# The second routing works on the paths that place_timing.py finds: a note where its longest is not nextpnr's.
compare_longest_paths() {
  awk '
    /^Longest path: / { ours = $3; slowest = 0 }
    /Max frequency for clock/ { mhz = $(NF - 5); if (!slowest || mhz < slowest) slowest = mhz }
    END {
      if (!ours || !slowest) exit
      theirs = 1e6 / slowest
      if ((ours - theirs) ^ 2 > 4) printf "note: longest path %d ps in place_timing.py, %d ps in nextpnr\n", ours, theirs
    }
  ' nextpnr.log >&2
}

mkdir -p "$directory"
cd "$directory"
rm -f report.json pins.json "$board.bit"

# A pseudo-board has no pins.
if [ ! -f "$project/boards/$board/connections.csv" ]; then
  place nextpnr-ecp5 "--$device" --package CABGA381 --speed 6 --json "$netlist" \
    --lpf "$project/constraints/$board.lpf" --lpf-allow-unconstrained --report report.json \
    --seed "$seed" "${timing[@]}"
  compare_longest_paths
  exit
fi

"$project/tools/hardware/write_constraints.sh" "$project" "$board" > pins.lpf
cat pins.lpf "$project/constraints/$board.lpf" > board.lpf

# nextpnr has no constraints for these: tools/synthesis compares them with its report.
awk -F, '
  FNR == 1 { file += 1; next }
  file == 1 { longest[$1] = $2; next }
  file == 2 { registered[$1] = $6 == "pad"; next }
  { signal = $1; sub(/\[.*/, "", signal); registers += registered[signal] }
  END {
    printf "{\"pad_registers\": %d, \"input_to_register_ns\": %s, \"register_to_output_ns\": %s}\n",
      registers, longest["input_to_register"], longest["register_to_output"]
  }
' "$project/constraints/delays.csv" "$project/constraints/signals.csv" \
  "$project/boards/$board/connections.csv" > pins.json

place nextpnr-ecp5 "--$device" --package CABGA381 --speed 6 --json "$netlist" \
  --lpf board.lpf --textcfg layout.config --report report.json --seed "$seed" "${timing[@]}" \
  --pre-place "$project/tools/hardware/place_memory.py"
compare_longest_paths
"$project/tools/hardware/pack_bitstream.sh" layout.config "$contents" "$firmware" "$board.bit"
