#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares products after synthesis for a Cyclone, on models of its cells, with those of their source.
# Usage: compare_multipliers.sh PROJECT DIRECTORY
set -euo pipefail
project=$1 directory=$2

rm -rf "$directory"
mkdir -p "$directory"
cp "$project/tests/netlist/products.v" "$directory"
"$project/tools/hardware/synthesize_cyclone.sh" "$project" products "$directory"
cd "$directory"
[ "$(grep -c '"type": "cyclone_multiplier"' netlist.json)" -gt 5 ] || { echo "failed: no multipliers are used"; exit 1; }
yosys -q -p "read_json netlist.json; delete t:\$scopeinfo; write_verilog -noattr netlist.v" > netlist.log
sed 's/^module products /module products_of_source /' products.v > products_of_source.v
verilator --binary -Wno-fatal -Wno-WIDTH -Wno-PINMISSING --top-module multiplier_pair -j 2 \
  "$project/tests/netlist/multiplier_pair.sv" products_of_source.v netlist.v "$project"/tests/netlist/cells/cyclone/*.v \
  "$project/tools/hardware/cyclone_cells.v" > verilator.log 2>&1 || { tail -n 40 verilator.log; exit 1; }
obj_dir/Vmultiplier_pair
