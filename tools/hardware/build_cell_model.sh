#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes a Verilated model of a netlist of ECP5 cells: (Yosys) -> what its cells do, by Yosys' own models of them
# and those of the given files -> (Verilator) -> static library.
# Usage: build_cell_model.sh DIRECTORY NAME ENTITY NETLIST.json [CELL.v|CONTROL.vlt...]
set -euo pipefail
directory=$1 name=$2 entity=$3 netlist=$4
shift 4

mkdir -p "$directory/verilated"
cd "$directory"

# Nets of one bit each, because a vector of which one bit follows from another looks like a loop to Verilator, and is
# slow; short names, of which the model is made in half the time; block RAMs are called block_ram_0, ... and oscillators
# oscillator_0, ... for tests that reach into them. Nothing is optimised: all cells stay.
yosys -q -p "read_json $netlist; hierarchy -top $entity; delete t:\$scopeinfo; splitnets; rename -hide;
  rename -enumerate -pattern block_ram_% t:DP16KD;
  rename -enumerate -pattern oscillator_% t:OSCG; rename -enumerate; write_verilog -noattr pins.v" > cells.log 2>&1 || { tail -n 20 cells.log; exit 1; }
# The Yosys models that simulate fast.
awk '/^module (PFUMX|L6MUX21|CCU2C|TRELLIS_FF|TRELLIS_DPR16X4) *\(/ { inside = 1 }
  inside { print }
  /^endmodule/ { inside = 0 }' "$(dirname "$(command -v yosys)")/../share/yosys/ecp5/cells_sim.v" > cells.v

# A port P whose pins can be left open ($_TBUF_) becomes two, P_level and P_driven: Verilator does not follow such pins.
awk '
  /^  \\\$_TBUF_ / { inside = 1; if (FNR != NR) next }
  inside && /^    \.[AE]\(/ { split($1, part, /[().]+/); value[part[2]] = part[3] }
  inside && /^    \.Y\(/ {
    split($1, part, /[().[\]]+/)
    if (FNR == NR) opens[part[3]] = 1
    else {
      printf "  assign %s_level[%s] = %s;\n", part[3], part[4], value["A"]
      printf "  assign %s_driven[%s] = %s;\n", part[3], part[4], value["E"]
    }
  }
  inside && /^  \);/ { inside = 0; if (FNR != NR) next }
  FNR == NR || inside { next }
  /^module / { for (port in opens) sub(/\(/, "(" port "_level, " port "_driven, ") }
  /^  output / {
    port = $NF
    sub(/;/, "", port)
    if (port in opens) {
      print
      sub(port ";", port "_level;")
      print
      sub(port "_level;", port "_driven;")
    }
  }
  { print }
' pins.v pins.v > netlist.v

export OBJCACHE=${OBJCACHE-$(command -v ccache || true)}
verilator --cc --build -j 2 --Mdir verilated --prefix "V$entity" --top-module "$entity" \
  -O3 --x-assign fast --x-initial fast --no-timing -Wno-fatal -Wno-WIDTH -Wno-PINMISSING \
  -MAKEFLAGS "OPT_FAST=-O1 OPT_SLOW=-O0" -CFLAGS "-fPIC" netlist.v cells.v "$@" > verilator.log 2>&1 ||
  { tail -n 40 verilator.log; exit 1; }

# One library of the model's and Verilator's objects, as build_model.sh makes it.
rm -f "lib$name.a"
(cd verilated && ar rcsT "../V.tmp.a" "V${entity}__ALL.a" libverilated.a && cd .. &&
  printf 'create lib%s.a\naddlib verilated/V%s__ALL.a\naddlib verilated/libverilated.a\nsave\nend\n' \
    "$name" "$entity" | ar -M)
rm -f V.tmp.a
