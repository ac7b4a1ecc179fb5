#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The processor with its memory alone as cells of an iCE40, to compare it with others: VHDL -> (GHDL) -> Verilog ->
# (Yosys) -> netlist.json and cells.json (how many) in the directory. The memory has no contents.
# Usage: synthesize_ice40.sh PROJECT BOARD DEVICE DIRECTORY [-gGENERIC=VALUE...]
set -euo pipefail
project=$1 board=$2 device=$3 directory=$4
shift 4
. "$project/tools/hardware/steps.sh"

mkdir -p "$directory"
cd "$directory"
rm -f netlist.json cells.json
"$project/tools/hardware/write_verilog.sh" "$project" "$board" "$directory" "$@"

# An iCE40 has no distributed memory for the registers, but block RAM can do the same.
awk '/^module register_file$/ { inside = 1; found = 1 }
  !inside { print }
  /^endmodule/ { inside = 0 }
  END { exit !found }' work/chip.v > work/synthesis.v ||
  { echo "failed: there is no register_file to put into block RAM" >&2; exit 1; }

case $device in
  hx8k) family=(-device hx) ;;
  up5k) family=(-device u -dsp) ;;
  *) echo "failed: no iCE40 is called $device" >&2; exit 1 ;;
esac
step yosys.log yosys -p "read_verilog -sv work/synthesis.v $project/tools/hardware/ice40_register_file.v;
  synth_ice40 -no-rw-check ${family[*]} -top $board -json netlist.json;
  tee -q -o cells.json stat -json -top $board"
