#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Everything that Quartus needs for a board with a Cyclone, in the directory: VHDL -> (GHDL) -> BOARD.v, the vendor's cells,
# the firmware as bank1_lane1.mif and so on, pins.tcl, BOARD.sdc, and make_project.tcl, which makes the project of them.
# Usage: write_quartus_project.sh PROJECT BOARD FIRMWARE.elf DIRECTORY [-gGENERIC=VALUE...]
set -euo pipefail
project=$1 board=$2 firmware=$3 directory=$4
shift 4
. "$project/tools/hardware/steps.sh"

mkdir -p "$directory"
cd "$directory"
rm -f ./*.v ./*.mif ./*.tcl ./*.sdc
"$project/tools/hardware/write_verilog.sh" "$project" "$board" "$directory" "$@"

# The memory is that of boards/cyclone; no places in the sources. A signal that only follows a register has no initial value of its own.
awk '
  /^ *\/\* .*\.vhd:[0-9:]+ *\*\/$/ { next }
  /^module memory_[0-9]+_/ { name = $2; split(name, part, "_"); size = part[2]; inside = 1; next }
  inside { inside = !/^endmodule/; next }
  /^  always @\*$/ { held = $0; next }
  held != "" {
    print held
    held = ""
    followed = /\(isignal\)/ ? $1 : ""
  }
  /^  initial$/ && followed != "" { initial = 1; next }
  initial {
    initial = 0
    if ($1 == followed) { followed = ""; next }
    print "  initial"
  }
  !/^  initial$/ && !/^    [a-z0-9_]+ = / { followed = "" }
  size != "" && $1 == name {
    print "  memory #("
    print "    .size_bytes(" size "))"
    print "    " $2 " ("
    placed += 1
    next
  }
  { print }
  END { exit placed != 1 }
' work/chip.v > "$board.v" || { echo "failed: there is not one memory to replace" >&2; exit 1; }
cp "$project"/boards/cyclone/*.v .

size=$(sed -nE 's/^ *\.size_bytes\(([0-9]+)\)\)$/\1/p' "$board.v")
"$project/tools/hardware/write_mif.sh" "$firmware" "$size" .

"$project/tools/hardware/write_constraints.sh" "$project" "$board" > pins.tcl
"$project/tools/hardware/write_delays.sh" "$project" "$board" > "$board.sdc"

property() { awk -F, -v name="$1" '$1 == name { print $2 }' "$project/boards/$board/device.csv"; }
{
  cat <<END
# Makes the Quartus project of $board: quartus_sh -t make_project.tcl
package require ::quartus::project
project_new -overwrite $board
set_global_assignment -name FAMILY "$(property family)"
set_global_assignment -name DEVICE $(property device)
set_global_assignment -name TOP_LEVEL_ENTITY $board
set_global_assignment -name PROJECT_OUTPUT_DIRECTORY output_files
END
  for file in *.v; do echo "set_global_assignment -name VERILOG_FILE $file"; done
  for file in *.mif; do echo "set_global_assignment -name MIF_FILE $file"; done
  cat <<END
set_global_assignment -name SDC_FILE $board.sdc
# A register without a value of its own is low after configuration, as in simulation.
set_global_assignment -name ALLOW_POWER_UP_DONT_CARE OFF
# The board's other chips stay unselected.
set_global_assignment -name RESERVE_ALL_UNUSED_PINS "AS INPUT TRI-STATED WITH WEAK PULL-UP"
END
  if [ "$(property family)" = "Cyclone II" ]; then
    cat <<'END'
# The erratum of a Cyclone II's block RAM with two clocks: port A of memory_lane.v never writes.
set_parameter -name CYCLONEII_SAFE_WRITE VERIFIED_SAFE
END
  fi
  cat <<'END'
source pins.tcl
export_assignments
project_close
END
} > make_project.tcl
rm -r work
