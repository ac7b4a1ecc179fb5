#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The whole chip for an ECP5 board: VHDL -> (GHDL) -> Verilog -> (Yosys) -> netlist -> (nextpnr) -> layout
# -> (ecppack) -> bitstream. Usage: synthesize_board.sh PROJECT BOARD FIRMWARE.elf DEVICE SEED DIRECTORY
set -euo pipefail
project=$1 board=$2 firmware=$3 device=$4 seed=$5 directory=$6

step() {
  local log=$1
  shift
  "$@" > "$log" 2>&1 || { tail -n 20 "$log" >&2; echo "failed: $1; log in $directory/$log" >&2; exit 1; }
}

mkdir -p "$directory/work"
cd "$directory"
rm -f work/* report.json "$board.bit"

mapfile -t files < <(find "$project/rtl" "$project/boards/$board" -name '*.vhd' | sort)
step ghdl.log ghdl -i --std=08 --workdir=work "${files[@]}"
step ghdl.log ghdl -m --std=08 --workdir=work "$board"
ghdl synth --std=08 --workdir=work --out=verilog "$board" > work/chip.v 2> ghdl.log ||
  { tail -n 20 ghdl.log >&2; exit 1; }

# The firmware becomes the initial contents of the memory, one file per lane of bytes.
riscv64-unknown-elf-objcopy -O binary "$firmware" work/firmware.bin
od -An -v -tx1 -w4 work/firmware.bin |
  awk '{ for (lane = 1; lane <= 4; lane++) print ($lane == "" ? "00" : $lane) > "work/lane" lane ".hex" }'
# Assertions are for simulation: Yosys has no $fatal. (GHDL's --no-formal fails on this design.)
sed -E -e 's/^( *)\$fatal\(.*\);/\1;/' \
  -e 's/^( *)reg \[7:0\] (lanes_n([1-4])_bytes)\[.*$/&\n\1initial $readmemh("work\/lane\3.hex", \2);/' \
  work/chip.v > work/synthesis.v
[ "$(grep -c readmemh work/synthesis.v)" = 4 ] ||
  { echo "failed: the memory has other names than rtl/memory/README.md says" >&2; exit 1; }

# A target of 14 ns keeps the mapper from doubling logic for paths that are fast enough.
step yosys.log yosys -p "read_verilog -sv work/synthesis.v $(echo "$project/boards/$board/"*.v);
  scratchpad -set abc9.D 14000;
  synth_ecp5 -no-rw-check -top $board -json work/netlist.json;
  tee -q -o cells.json stat -json -top $board"

# Pins: what the top entity's ports are connected to, and where these signals lie on the board.
awk -F, -v OFS= '
  FNR == 1 { next }
  FILENAME ~ /pins.csv$/ { pin[$1] = $2; standard[$1] = $3; next }
  !($2 in pin) { print "no pin for " $2 > "/dev/stderr"; exit 1 }
  { print "LOCATE COMP \"", $1, "\" SITE \"", pin[$2], "\";"
    print "IOBUF PORT \"", $1, "\" ", standard[$2], ";" }
' "$project/boards/$board/pins.csv" "$project/boards/$board/connections.csv" > work/pins.lpf
cat work/pins.lpf "$project/constraints/$board.lpf" > board.lpf

step nextpnr.log nextpnr-ecp5 "--$device" --package CABGA381 --speed 6 --json work/netlist.json \
  --lpf board.lpf --textcfg work/layout.config --report report.json --seed "$seed" --timing-allow-fail
step ecppack.log ecppack --compress work/layout.config "$board.bit"
