#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes a Verilated model of one entity: VHDL -> (GHDL) -> Verilog -> (Verilator) -> static library.
# Usage: build_model.sh DIRECTORY NAME ENTITY PREFIX file.vhd... -- [-gGENERIC=VALUE...] -- [VERILATOR_ARGUMENT...]
set -euo pipefail
directory=$1 name=$2 entity=$3 prefix=$4
shift 4
files=() generics=()
while [ "$1" != -- ]; do files+=("$1"); shift; done
shift
while [ "$1" != -- ]; do generics+=("$1"); shift; done
shift

rm -rf "$directory/work"
mkdir -p "$directory/work" "$directory/verilated"
cd "$directory"
ghdl -i --std=08 -fpsl --workdir=work "${files[@]}"
ghdl -m --std=08 -fpsl --workdir=work "$entity" > ghdl.log || { cat ghdl.log; exit 1; }
ghdl synth --std=08 -fpsl --no-assert-cover --workdir=work --out=verilog "${generics[@]}" "$entity" > work/netlist.v 2> synth.log ||
  { cat synth.log; exit 1; }
awk -f "$(dirname "$0")/name_registers.awk" work/netlist.v work/netlist.v > "$entity.v"

# The netlist has no delays and many helper nets: names and unused nets are of no interest, all else is.
export OBJCACHE=${OBJCACHE-$(command -v ccache || true)}
verilator --cc --build -j 2 --Mdir verilated --prefix "$prefix" --top-module "$entity" \
  -O3 --x-assign fast --x-initial fast --assert --no-timing \
  -Wno-DECLFILENAME -Wno-UNUSEDSIGNAL -Wno-UNOPTFLAT -Wno-fatal -Werror-CASEINCOMPLETE -Werror-WIDTH \
  -Werror-LATCH -CFLAGS "-O2 -fPIC" "$@" "$entity.v" > verilator.log 2>&1 || { cat verilator.log; exit 1; }

rm -f "lib$name.a"
(cd verilated && ar rcsT "../V.tmp.a" "${prefix}__ALL.a" libverilated.a && cd .. &&
  printf 'create lib%s.a\naddlib verilated/%s__ALL.a\naddlib verilated/libverilated.a\nsave\nend\n' \
    "$name" "$prefix" | ar -M)
rm -f V.tmp.a
