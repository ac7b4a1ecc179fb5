#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What write_quartus_project.sh has left in DIRECTORY as cells of a Cyclone IV E, to see by an open tool that it can be
# synthesised, about what it takes and that it works: (Yosys) -> netlist.json and cells.json (how many) in the directory.
# Quartus has its own synthesis, and other cells for a Cyclone II, which Yosys does not know.
# Usage: synthesize_cyclone.sh PROJECT BOARD DIRECTORY
set -euo pipefail
project=$1 board=$2 directory=$3
. "$project/tools/hardware/steps.sh"

cd "$directory"
rm -f netlist.json cells.json
step yosys.log yosys -p "read_verilog -lib +/intel/cycloneive/cells_sim.v;
  read_verilog -lib $project/tools/hardware/cyclone_cells.v;
  read_verilog -sv $(printf '%s ' ./*.v);
  hierarchy -check -top $board;
  synth_intel -family cycloneive -top $board -run coarse:map_bram;
  memory_libmap -lib $project/tools/hardware/cyclone_block_ram.txt;
  techmap -map $project/tools/hardware/cyclone_map.v;
  synth_intel -family cycloneive -top $board -run map_ffram:check;
  check -assert;
  write_json netlist.json;
  tee -q -o cells.json stat -json -top $board"
