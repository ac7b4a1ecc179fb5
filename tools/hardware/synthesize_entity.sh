#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What synthesis leaves of one entity alone: VHDL -> (GHDL) -> Verilog -> (Yosys) -> netlist.json of an ECP5's cells, or of
# a Cyclone IV E's. Usage: synthesize_entity.sh ecp5|cyclone ENTITY file.vhd... DIRECTORY
set -euo pipefail
project=$(cd "$(dirname "$0")/../.." && pwd -P)
family=$1 entity=$2 directory=${!#}
files=("${@:3:$# - 3}")

rm -rf "$directory/work"
mkdir -p "$directory/work"
cd "$directory"
ghdl -i --std=08 --workdir=work "${files[@]}"
ghdl -m --std=08 --workdir=work "$entity" > ghdl.log || { cat ghdl.log; exit 1; }
ghdl synth --std=08 --workdir=work --out=verilog "$entity" > work/entity.v 2> synth.log ||
  { cat synth.log; exit 1; }

# As tools/hardware/write_verilog.sh does it.
sed -E 's/^( *)\$fatal\(.*\);/\1;/' work/entity.v > "$entity.v"
if [ "$family" = cyclone ]; then
  exec "$project/tools/hardware/synthesize_cyclone.sh" "$project" "$entity" "$directory"
fi
yosys -q -p "read_verilog -sv $entity.v;
  scratchpad -set abc9.D 14000;
  synth_ecp5 -no-rw-check -top $entity -json netlist.json;
  tee -q -o cells.json stat -json -top $entity" > yosys.log 2>&1 || { tail -n 20 yosys.log; exit 1; }
grep -q '"TRELLIS_FF"' cells.json || { echo "the netlist is not of ECP5 cells"; exit 1; }
