#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A program as the contents of the memory of boards/cyclone: a file of Quartus for each lane of bytes and each bank of the
# memory, lane1.mif to lane4.mif and, of a memory of two banks, upper_lane1.mif to upper_lane4.mif, in the directory.
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

# A size that is no power of two is three quarters of one: then two thirds of it are the first bank.
bank=1
while [ $((2 * bank)) -le "$size" ]; do bank=$((2 * bank)); done
[ "$size" = $bank ] || [ $((2 * size)) = $((3 * bank)) ] || { echo "failed: there is no memory of $size bytes" >&2; exit 1; }

cd "$directory"
od -An -v -tx1 -w4 "$image" | awk -v words=$((size / 4)) -v first=$((bank / 4)) '
  function open_lanes(bank, depth, lane) {
    for (lane = 1; lane <= 4; lane++) {
      file[lane] = bank "lane" lane ".mif"
      print "WIDTH = 8;\nDEPTH = " depth ";\nADDRESS_RADIX = HEX;\nDATA_RADIX = HEX;\nCONTENT BEGIN" > file[lane]
    }
    address = 0
  }
  function close_lanes(lane) {
    for (lane = 1; lane <= 4; lane++) { print "END;" > file[lane]; close(file[lane]) }
  }
  function write_word(a, b, c, d) {
    if (count == 0) open_lanes("", first)
    if (count == first) { close_lanes(); open_lanes("upper_", words - first) }
    printf "  %X : %s;\n", address, a > file[1]
    printf "  %X : %s;\n", address, b > file[2]
    printf "  %X : %s;\n", address, c > file[3]
    printf "  %X : %s;\n", address, d > file[4]
    address += 1
    count += 1
  }
  { write_word($1, $2 == "" ? "00" : $2, $3 == "" ? "00" : $3, $4 == "" ? "00" : $4) }
  END { while (count < words) write_word("00", "00", "00", "00"); close_lanes() }
'
