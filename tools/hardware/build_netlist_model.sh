#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes a Verilated model of what synthesis leaves of one entity: VHDL -> (GHDL) -> Verilog -> (Yosys) -> ECP5
# cells -> (Yosys) -> what these cells do, by Yosys' own models of them -> (Verilator) -> static library.
# Usage: build_netlist_model.sh DIRECTORY NAME ENTITY file.vhd...
set -euo pipefail
directory=$1 name=$2 entity=$3
shift 3

rm -rf "$directory/work"
mkdir -p "$directory/work" "$directory/verilated"
cd "$directory"
ghdl -i --std=08 --workdir=work "$@"
ghdl -m --std=08 --workdir=work "$entity" > ghdl.log || { cat ghdl.log; exit 1; }
ghdl synth --std=08 --workdir=work --out=verilog "$entity" > work/entity.v 2> synth.log ||
  { cat synth.log; exit 1; }

# As tools/hardware/synthesize_board.sh does it.
sed -E 's/^( *)\$fatal\(.*\);/\1;/' work/entity.v > work/synthesis.v
yosys -q -p "read_verilog -sv work/synthesis.v;
  scratchpad -set abc9.D 14000;
  synth_ecp5 -no-rw-check -top $entity;
  tee -q -o cells.json stat -json -top $entity;
  write_verilog -noattr netlist.v" > yosys.log 2>&1 || { tail -n 20 yosys.log; exit 1; }
grep -q '"TRELLIS_FF"' cells.json || { echo "the netlist is not of ECP5 cells"; exit 1; }

# In files of their own, so that nothing but the netlist comes here. Not optimised: all cells stay.
yosys -q -p "read_verilog netlist.v; read_verilog -DYOSYS +/ecp5/cells_sim.v;
  hierarchy -check -top $entity; proc; flatten; opt_clean;
  write_verilog -noattr behaviour.v" > cells.log 2>&1 || { tail -n 20 cells.log; exit 1; }

export OBJCACHE=${OBJCACHE-$(command -v ccache || true)}
verilator --cc --build -j 2 --Mdir verilated --prefix "V$entity" --top-module "$entity" \
  -O3 --x-assign fast --x-initial fast --no-timing -Wno-fatal -Wno-WIDTH -Wno-UNOPTFLAT \
  -CFLAGS "-O1 -fPIC" behaviour.v > verilator.log 2>&1 || { tail -n 40 verilator.log; exit 1; }

# One library of the model's and Verilator's objects, as build_model.sh makes it.
rm -f "lib$name.a"
(cd verilated && ar rcsT "../V.tmp.a" "V${entity}__ALL.a" libverilated.a && cd .. &&
  printf 'create lib%s.a\naddlib verilated/V%s__ALL.a\naddlib verilated/libverilated.a\nsave\nend\n' \
    "$name" "$entity" | ar -M)
rm -f V.tmp.a
