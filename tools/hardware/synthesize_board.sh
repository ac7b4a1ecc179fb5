#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The whole chip for an ECP5 board, or a part of it alone: VHDL -> (GHDL) -> Verilog -> (Yosys) -> netlist of
# cells, netlist.json and cells.json (how many) in the directory. place_board.sh makes the bitstream of it. With "-" in
# place of a program the memory's contents are random, contents.hex in the directory: by them pack_bitstream.sh finds where
# each bit of the memory lies in a layout, and puts a program there.
# Usage: synthesize_board.sh PROJECT BOARD FIRMWARE.elf|- DIRECTORY [-gGENERIC=VALUE...]
set -euo pipefail
project=$1 board=$2 firmware=$3 directory=$4
shift 4
. "$project/tools/hardware/steps.sh"

mkdir -p "$directory"
cd "$directory"
rm -f netlist.json cells.json
"$project/tools/hardware/write_verilog.sh" "$project" "$board" "$directory" "$@"

# The contents of the memory, one file per bank and lane of bytes.
bank_words=$(sed -nE 's/^ *reg \[7:0\] banks_n[0-9]+_lanes_n1_bytes\[([0-9]+):0\].*/\1 + 1/p' work/chip.v)
words=$(($(paste -sd+ <<< "$bank_words")))
rm -f contents.hex
if [ "$firmware" = - ]; then
  step ecpbram.log ecpbram --generate contents.hex --width 32 --depth $words --seed 1
  sed -E 's/^(..)(..)(..)(..)$/\4 \3 \2 \1/' contents.hex > work/contents
else
  riscv64-unknown-elf-objcopy -O binary "$firmware" work/firmware.bin
  size=$(stat -c %s work/firmware.bin)
  [ "$size" -le $((4 * words)) ] ||
    { echo "failed: $firmware has $size bytes, and the memory $((4 * words))" >&2; exit 1; }
  od -An -v -tx1 -w4 work/firmware.bin > work/contents
fi
# A bank that the program does not reach has empty files.
banks=$(wc -l <<< "$bank_words")
for ((bank = 1; bank <= banks; bank++)); do
  for lane in 1 2 3 4; do : > "work/bank${bank}_lane$lane.hex"; done
done
awk -v bank_words="$(paste -sd, <<< "$bank_words")" '
  BEGIN { split(bank_words, depths, ","); bank = 1; end = depths[1] + 0 + 1 }
  NR > end { bank++; end += depths[bank] + 0 + 1 }
  { for (lane = 1; lane <= 4; lane++) print ($lane == "" ? "00" : $lane) > "work/bank" bank "_lane" lane ".hex" }
' work/contents
sed -E 's/^( *)reg \[7:0\] (banks_n([0-9]+)_lanes_n([1-4])_bytes)\[.*$/&\n\1initial $readmemh("work\/bank\3_lane\4.hex", \2);/' \
  work/chip.v > work/synthesis.v
[ "$(grep -c readmemh work/synthesis.v)" = $((4 * banks)) ] ||
  { echo "failed: the memory has other names than rtl/memory/README.md says" >&2; exit 1; }

# Yosys has no delays for the block RAM, so it would optimise the wrong paths. For mapping, each
# wire to and from the memory passes a cell that only adds delay (ps). It is less than nextpnr's: these paths
# are the longest even so and are mapped as short as they can be, and every other path may become as long.
# It lies before the gates that join the banks, which are mapped with those behind them. The wires from the processor to
# the parts on its bus are long as well: these lie all over the device.
cat > work/ways.v <<'END'
(* blackbox, abc9_box *) module way_from_block_ram (input I, output O);
  specify
    (I => O) = 5100;
  endspecify
endmodule
(* blackbox, abc9_box *) module way_to_block_ram (input I, output O);
  specify
    (I => O) = 3000;
  endspecify
endmodule
(* blackbox, abc9_box *) module way_to_bus (input I, output O);
  specify
    (I => O) = 1800;
  endspecify
endmodule
(* blackbox, abc9_box *) module way_to_control (input I, output O);
  specify
    (I => O) = 900;
  endspecify
endmodule
END
cat > work/no_ways.v <<'END'
module way_from_block_ram (input I, output O); assign O = I; endmodule
module way_to_block_ram (input I, output O); assign O = I; endmodule
module way_to_bus (input I, output O); assign O = I; endmodule
module way_to_control (input I, output O); assign O = I; endmodule
END
# An enable or reset of a register comes over a wire, while its data comes from a gate at its side.
cat > work/control_ways.v <<'END'
(* techmap_celltype = "TRELLIS_FF" *)
module register_with_ways (input CLK, LSR, CE, DI, output Q);
  parameter GSR = "ENABLED", CEMUX = "1", CLKMUX = "CLK", LSRMUX = "LSR", SRMODE = "LSR_OVER_CE", REGSET = "RESET";
  parameter _TECHMAP_CONSTMSK_CE_ = 1'b0;
  parameter _TECHMAP_CONSTMSK_LSR_ = 1'b0;
  wire enable, reset;
  generate
    if (CEMUX == "1") assign enable = 1'b1;  // It has none: a wire would keep it out of a slice with others.
    else if (_TECHMAP_CONSTMSK_CE_) assign enable = CE;
    else way_to_control way_to_enable (.I(CE), .O(enable));
    if (_TECHMAP_CONSTMSK_LSR_) assign reset = LSR;
    else way_to_control way_to_reset (.I(LSR), .O(reset));
  endgenerate
  TRELLIS_FF #(.GSR(GSR), .CEMUX(CEMUX), .CLKMUX(CLKMUX), .LSRMUX(LSRMUX), .SRMODE(SRMODE), .REGSET(REGSET))
    _TECHMAP_REPLACE_ (.CLK(CLK), .LSR(reset), .CE(enable), .DI(DI), .Q(Q));
endmodule
END
awk -v banks=$banks '
  BEGIN {
    from_block_ram = banks == 1 ? "^ *assign (instruction_data|data) = [^;]*;" \
                                : "^ *assign n[0-9]+_o = bank_(instruction|data)[[][0-9]+:[0-9]+[]];"
  }
  /^module data_access(_|$)/ { at_bus = 1 }
  at_bus && /^ *assign bus_request_[a-z_]+ = n[0-9]+_o;/ {
    width = $2 ~ /address|data/ ? "[31:0]" : $2 ~ /bytes/ ? "[3:0]" : "[0:0]"
    sub(/;/, "", $4)
    print "  way_to_bus way_to_" $2 " " width " (.I(" $4 "), .O(" $2 "));"
    next
  }
  /^endmodule/ { at_bus = 0 }
  /^module memory(_|$)/ { inside = 1 }
  inside && match($0, /^ *input +(\[[0-9]+:0\] )?(instruction|data)_request_[a-z_]+/) {
    width = $2 ~ /^\[/ ? $2 : "[0:0]"
    name = $2 ~ /^\[/ ? $3 : $2
    sub(/[,)].*/, "", name)
    ways = ways "  wire " width " near_" name ";\n  way_to_block_ram way_to_" name " " width \
      " (.I(" name "), .O(near_" name "));\n"
    print
    next
  }
  inside && !body { print; if (/\);/) { body = 1; printf "%s", ways }; next }
  inside && match($0, from_block_ram) {
    split($0, part, /[ =;]+/)
    split(part[4], bits, /[^0-9]+/)
    if (banks == 1 || bits[2] - bits[3] == 31) {
      print "  way_from_block_ram way_from_" part[3] " [31:0] (.I(" part[4] "), .O(" part[3] "));"
      next
    }
  }
  inside { gsub(/(instruction|data)_request_/, "near_&") }
  /^endmodule/ { inside = 0 }
  { print }
' work/synthesis.v > work/with_ways.v
[ "$(grep -c 'way_\(to\|from\)_block_ram' work/with_ways.v)" = $((banks > 1 ? 9 + 3 * banks : 11)) ] ||
  { echo "failed: the memory has other ports than this script knows" >&2; exit 1; }
# The memory alone has no bus.
[ "$(grep -c 'way_to_bus way' work/with_ways.v)" = $((5 * $(grep -c '^module data_access' work/synthesis.v))) ] ||
  { echo "failed: the bus has other signals than this script knows" >&2; exit 1; }

# Nor does it count the wires to carry chains and distributed memory, which it maps as boxes: these
# delays include them, in ps.
wire=900
awk -v wire=$wire '
  /^\(\*/ { attributes = $0 }
  /^module (CCU2C|TRELLIS_DPR16X4) *\(/ { inside = 1; print attributes }
  inside && /\([A-D][01] => / { sub(/[0-9]+;/, $NF + wire ";") }
  inside && /\(RAD \*> DO\)/ { sub(/0;/, 240 + wire ";") }
  inside
  /^endmodule/ { inside = 0 }
' "$(dirname "$(command -v yosys)")/../share/yosys/ecp5/cells_sim.v" > work/cells.v
[ "$(grep -c '= 1[0-9]*;' work/cells.v)" = 21 ] ||
  { echo "failed: Yosys' cells have other delays than this script knows" >&2; exit 1; }

# synth_ecp5 with a mapping of its own: a wire takes that long, and what takes less than 8.5 ns is not made
# faster. No tables of more than four inputs: what comes out of the multiplexers that join them goes a long
# way to a register, while a table's output has one at its side.
step yosys.log yosys -p "read_verilog -lib -specify work/ways.v;
  read_verilog -sv work/with_ways.v $(find "$project/boards" -path "$project/boards/$board/*.v" -printf '%p ');
  synth_ecp5 -no-rw-check -top $board -run begin:map_luts;
  techmap -map +/ecp5/latches_map.v;
  techmap -max_iter 1 -map work/control_ways.v;
  clean;
  write_rtlil work/unmapped.il"
unmapped="read_verilog -lib -specify +/ecp5/cells_sim.v +/ecp5/cells_bb.v;
  read_rtlil -nooverwrite work/unmapped.il;
  read_verilog -overwrite -lib -specify work/cells.v;
  read_verilog -overwrite -lib -specify work/ways.v"

# Every path may become as long as the longest, and how long that is depends on the form of the logic before it is
# mapped: small changes anywhere may cost a level of gates. So some forms are mapped, and the fastest is taken.
map="&if -W $wire -D 8500 -v"
cat > work/recipes <<END
&sweep; &dch; $map; &synch2 -K 4; $map
&sweep; &dch; $map; &synch2 -K 4 -f; $map
&sweep; &dch; $map; &synch2 -K 4 -R 0; $map; &synch2 -K 4 -R 0; $map
&sweep; &dch -f; $map; &synch2 -K 4; $map
&sweep; &b -d; &dch; $map; &synch2 -K 4; $map
&sweep; &b -d; &dch -x; $map; &synch2 -K 4; $map
&sweep; &b -a; &dch; $map; &synch2 -K 4; $map
&sweep; &synch2 -K 4; $map; &synch2 -K 4; $map
&sweep; &synch2 -K 4; $map
&sweep; &b -a; &synch2 -K 4; $map; &synch2 -K 4; $map
END
echo "&sweep; $map" > work/recipe
rm -rf _tmp_yosys-abc-*
step logic.log yosys -p "$unmapped; abc9 -maxlut 4 -W $wire -D 8500 -script work/recipe -nocleanup"
logic=$(echo _tmp_yosys-abc-*)
[ -f "$logic/input.xaig" ] || { echo "failed: Yosys leaves no logic to map, see $directory/logic.log" >&2; exit 1; }
# What it takes, in ps, and how many gates. With some recipes abc ends early, with status 0: they print no mark.
try_recipe() {
  { printf 'read_lut %s/input.lut\nread_box %s/input.box\n&read %s/input.xaig\n' "$logic" "$logic" "$logic"
    sed -n "$1p" work/recipes | tr ';' '\n'
    echo "echo this recipe has been followed to its end"; } > "work/recipe$1"
  yosys-abc -s -f "work/recipe$1" > "recipe$1.log" 2>&1 || :
  grep -q '^this recipe has been followed to its end' "recipe$1.log" || return 0
  sed -nE "s/^A: +Del = +([0-9.]+)\. +Ar = +([0-9.]+)\. .*/\1 \2 $1/p" "recipe$1.log" | tail -n 1
}
export -f try_recipe
export logic
best=$(seq "$(wc -l < work/recipes)" | xargs -P "$(nproc)" -I NUMBER bash -c 'try_recipe NUMBER' | tee recipes.log |
  sort -n -k1,1 -k2,2 -k3,3 | awk 'NR == 1 { print $3 }')
rm -rf "$logic"
[ -n "$best" ] || { echo "failed: no mapping, see $directory/recipe1.log" >&2; exit 1; }
sed -n "${best}p" work/recipes > work/recipe

step mapping.log yosys -p "$unmapped;
  abc9 -maxlut 4 -W $wire -D 8500 -script work/recipe;
  techmap -map work/no_ways.v;
  clean;
  synth_ecp5 -no-rw-check -top $board -run map_cells: -json netlist.json;
  tee -q -o cells.json stat -json -top $board"
