#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A program as the contents of the memory of boards/cyclone: a file of Quartus for each bank of the memory and each lane of
# bytes, bank1_lane1.mif to bank3_lane4.mif, in the directory.
# Usage: write_mif.sh PROGRAM.elf|PROGRAM.bin SIZE_BYTES DIRECTORY
set -euo pipefail
program=$1 size=$2 directory=$3

image=$(mktemp)
trap 'rm -f "$image"' EXIT
case $program in
  *.bin) cp "$program" "$image" ;;
  *) riscv64-unknown-elf-objcopy -O binary "$program" "$image" ;;
esac
[ "$(stat -c %s "$image")" -le "$size" ] || { echo "failed: the program is larger than the memory" >&2; exit 1; }

# Each 1 among the size's binary digits is a bank, the largest first (rtl/memory/memory.vhd).
banks=
for ((place = 30; place >= 3; place--)); do
  if ((size >> place & 1)); then banks="$banks $((1 << (place - 2)))"; fi
done
((size % 8 == 0)) && [ "$(wc -w <<< "$banks")" -le 3 ] || { echo "failed: there is no memory of $size bytes" >&2; exit 1; }

cd "$directory"
od -An -v -tx1 -w4 "$image" | awk -v banks="$banks" '
  BEGIN { bank_count = split(banks, depths) }
  function open_lanes(depth, lane) {
    for (lane = 1; lane <= 4; lane++) {
      file[lane] = "bank" bank "_lane" lane ".mif"
      print "WIDTH = 8;\nDEPTH = " depth ";\nADDRESS_RADIX = HEX;\nDATA_RADIX = HEX;\nCONTENT BEGIN" > file[lane]
    }
  }
  function close_lanes(lane) {
    for (lane = 1; lane <= 4; lane++) { print "END;" > file[lane]; close(file[lane]) }
  }
  function write_word(a, b, c, d) {
    if (address == 0) { bank++; open_lanes(depths[bank]) }
    printf "  %X : %s;\n", address, a > file[1]
    printf "  %X : %s;\n", address, b > file[2]
    printf "  %X : %s;\n", address, c > file[3]
    printf "  %X : %s;\n", address, d > file[4]
    address += 1
    if (address == depths[bank]) { close_lanes(); address = 0 }
  }
  { write_word($1, $2 == "" ? "00" : $2, $3 == "" ? "00" : $3, $4 == "" ? "00" : $4) }
  END { while (bank < bank_count || address > 0) write_word("00", "00", "00", "00") }
'
