#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Lets the real OpenOCD, and gdb through it, debug the co-simulated chip.
# Usage: debug_chip.sh openocd|gdb|firmware STEPFABRIC PROJECT PROGRAMS
# PROGRAMS is a folder with sleeper.elf and counter.elf.
set -euo pipefail
dialogue=$1 stepfabric=$2 project=$3 programs=$4
not_installed=77
command -v openocd > /dev/null || { echo "openocd is not installed"; exit $not_installed; }
[ "$dialogue" != gdb ] || command -v gdb-multiarch > /dev/null ||
  { echo "gdb-multiarch is not installed"; exit $not_installed; }

folder=$(mktemp -d)
: > "$folder/chip.log"
debugged=("$programs/sleeper.elf")
[ "$dialogue" != firmware ] || debugged=(--pty "$folder/terminal")
"$stepfabric" debug "${debugged[@]}" --port 0 > "$folder/chip.log" 2>&1 &
chip=$!
trap 'kill "$chip" 2>/dev/null || true; wait "$chip" || true; cat "$folder"/*.log; rm -rf "$folder"' EXIT

port=
for ((tries = 0; tries < 1200 && ${#port} == 0; tries++)); do
  port=$(sed -n 's/.* on port \([0-9]*\) .*/\1/p' "$folder/chip.log")
  kill -0 "$chip" || { echo "the chip does not run"; exit 1; }
  sleep 0.1
done

connection=(openocd -c "set port $port" -c "telnet_port disabled" -c "tcl_port disabled")
files=(-f "$project/tools/debug/simulation.cfg")
case $dialogue in
  openocd)
    symbols=$(riscv64-unknown-elf-nm "$programs/counter.elf" |
      awk '$3 ~ /^(loop|counted|counter|stop)$/ { printf "set %s 0x%s; ", $3, $1 }')
    "${connection[@]}" -c "gdb_port disabled" -c "set program $programs/counter.elf; $symbols" \
      "${files[@]}" -f "$project/tests/debug/dialogue.tcl" > "$folder/dialogue.log" 2>&1
    ;;
  gdb)
    pipe="$(printf '"%s" ' "${connection[@]}" -c "gdb_port pipe; log_output $folder/openocd.log" "${files[@]}")"
    gdb-multiarch -q -nx -batch -x "$project/tools/debug/chip.gdb" "$programs/counter.elf" \
      -ex "target extended-remote | $pipe" -x "$project/tests/debug/dialogue.gdb" > "$folder/dialogue.log" 2>&1
    ;;
  firmware)
    # Keeps the port open. What is said before the firmware listens is lost.
    exec 3<> "$folder/terminal"
    until IFS= read -r -t 1 -u 3 answer && [[ $answer == ok* ]]; do
      kill -0 "$chip"
      printf 'M105\n' >&3
    done
    printf 'M104 S200\n' >&3
    "${connection[@]}" -c "gdb_port disabled" "${files[@]}" -f "$project/tests/debug/halted_firmware.tcl" \
      > "$folder/dialogue.log" 2>&1
    ;;
esac
grep -q '^PASSED' "$folder/dialogue.log"
