#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes a Verilated model of a board's top entity, with the chip in it: VHDL -> (GHDL) -> Verilog -> (Verilator) -> static
# library with the header Vboard.h. Its clock is the reference; sim/boards has stand-ins for the vendors' cells.
# Usage: build_board_model.sh PROJECT BOARD CLOCK_HZ DIRECTORY NAME [-gGENERIC=VALUE...]
set -euo pipefail
project=$1 board=$2 clock_hz=$3 directory=$4 name=$5
shift 5

rm -rf "$directory/work"
mkdir -p "$directory/work" "$directory/verilated"
cd "$directory"
mapfile -t files < <(find "$project/rtl" "$project/boards/cyclone" "$project/boards/$board" "$project/sim/boards" -name '*.vhd' | sort)
ghdl -i --std=08 --workdir=work "${files[@]}"
ghdl -m --std=08 --warn-no-binding --workdir=work "$board" > ghdl.log || { cat ghdl.log; exit 1; }
# The chip's clock is the reference on a Cyclone.
clock=reference_clock_hz
grep -q "^    $clock :" "$project/boards/$board/$board.vhd" || clock=clock_frequency_hz
ghdl synth --std=08 --workdir=work --out=verilog "-g$clock=$clock_hz" "$@" "$board" \
  > work/netlist.v 2> synth.log || { cat synth.log; exit 1; }
# An instance is called as a keyword of SystemVerilog. What is left open has no level: the model says apart what is driven.
awk -f "$project/tools/hardware/name_registers.awk" work/netlist.v work/netlist.v |
  sed -E "s/^(  [a-z0-9_]+) cross \($/\1 cross_instance (/; s/1'bz/1'b0/g" > "$board.v"

cells=()
[ ! -f "$project/sim/boards/${board}_cells.v" ] || cells=("$project/sim/boards/${board}_cells.v")
export OBJCACHE=${OBJCACHE-$(command -v ccache || true)}
verilator --cc --build -j 2 --Mdir verilated --prefix Vboard --top-module "$board" \
  -O3 --x-assign fast --x-initial fast --assert --no-timing \
  -Wno-DECLFILENAME -Wno-UNUSEDSIGNAL -Wno-UNOPTFLAT -Wno-fatal -Werror-CASEINCOMPLETE -Werror-WIDTH -Werror-LATCH \
  -CFLAGS "-O3 -fPIC -DVL_USER_STOP -DVL_USER_FATAL" "$project/sim/boards/board.vlt" "$board.v" "${cells[@]}" \
  > verilator.log 2>&1 || { cat verilator.log; exit 1; }

# One library of the model's and Verilator's objects, as build_model.sh makes it.
rm -f "lib$name.a"
(cd verilated && ar rcsT "../V.tmp.a" Vboard__ALL.a libverilated.a && cd .. &&
  printf 'create lib%s.a\naddlib verilated/Vboard__ALL.a\naddlib verilated/libverilated.a\nsave\nend\n' "$name" | ar -M)
rm -f V.tmp.a
