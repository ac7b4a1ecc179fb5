#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The top entity of a board, or a test's, as Verilog that Yosys reads: VHDL -> (GHDL) -> work/chip.v in the directory.
# Usage: write_verilog.sh PROJECT TOP DIRECTORY [-gGENERIC=VALUE...]
set -euo pipefail
project=$1 top=$2 directory=$3
shift 3
. "$project/tools/hardware/steps.sh"

mkdir -p "$directory/work"
cd "$directory"
rm -f work/*

# A board has a folder; another top entity is one of testbench, or a part of the chip.
folder=$project/boards/$top
[ -d "$folder" ] || folder=$(dirname "$(find "$project/testbench" "$project/rtl" -name "$top.vhd" | grep .)")
mapfile -t files < <(find "$project/rtl" "$project/boards/cyclone" -name '*.vhd' | sort)
step ghdl.log ghdl -i --std=08 --workdir=work "${files[@]}" "$folder"/*.vhd
step ghdl.log ghdl -m --std=08 --workdir=work "$top"
ghdl synth --std=08 --workdir=work --out=verilog "$@" "$top" > work/vhdl.v 2> ghdl.log ||
  { tail -n 20 ghdl.log >&2; exit 1; }
# Assertions are for simulation: Yosys has no $fatal. (GHDL's --no-formal fails on this design.)
sed -E 's/^( *)\$fatal\(.*\);/\1;/' work/vhdl.v > work/chip.v
