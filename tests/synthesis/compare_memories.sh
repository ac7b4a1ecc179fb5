#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares the memory of boards/cyclone, on models of the vendor's cells, with that of rtl/memory, as GHDL writes it.
# Usage: compare_memories.sh PROJECT DIRECTORY SIZE_BYTES
set -euo pipefail
project=$1 directory=$2 size=$3

rm -rf "$directory"
mkdir -p "$directory/work"
cd "$directory"
ghdl -i --std=08 --workdir=work "$project"/rtl/memory/*.vhd
ghdl -m --std=08 --workdir=work memory
ghdl synth --std=08 --workdir=work --out=verilog -gsize_bytes="$size" memory |
  sed -E 's/^module memory(_[0-9]+)?$/module memory_of_rtl/; s/^( *)\$fatal\(.*\);/\1;/' > memory_of_rtl.v
verilator --binary -Wno-fatal -Wno-WIDTH -Wno-PINMISSING --top-module memory_pair "-DSIZE_BYTES=$size" -j 2 \
  "$project/tests/synthesis/memory_pair.sv" memory_of_rtl.v "$project"/boards/cyclone/memory*.v \
  "$project/tools/hardware/cyclone_cells.v" > verilator.log 2>&1 || { tail -n 40 verilator.log; exit 1; }
printf '' > nothing.bin
"$project/tools/hardware/write_mif.sh" nothing.bin "$size" .
obj_dir/Vmemory_pair
