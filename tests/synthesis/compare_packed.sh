#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A program that is put into the layout of a memory (pack_bitstream.sh) gives the bitstream that a synthesis with this program
# gives. Usage: compare_packed.sh PROJECT DIRECTORY
set -euo pipefail
project=$1 directory=$2
tools=$project/tools/hardware

rm -rf "$directory"
mkdir -p "$directory"
cd "$directory"

# More than the memory's first two banks, and less than all.
LC_ALL=C awk 'BEGIN { srand(1); for (i = 0; i < 100000; i++) printf "%c", 1 + int(rand() * 127) }' > program.bin
riscv64-unknown-elf-objcopy -I binary -O elf32-littleriscv program.bin program.elf

# The memory alone: half a minute in place of an hour. It has 209 ports, and this package 245 pins.
place() {
  nextpnr-ecp5 --45k --package CABGA554 --speed 6 --json "$1/netlist.json" --lpf-allow-unconstrained \
    --textcfg "$1/layout.config" --seed 1 > "$1/nextpnr.log" 2>&1 || { tail -n 20 "$1/nextpnr.log"; exit 1; }
}
"$tools/synthesize_board.sh" "$project" memory - "$PWD/random" -gsize_bytes=106496
"$tools/synthesize_board.sh" "$project" memory "$PWD/program.elf" "$PWD/with_program" -gsize_bytes=106496
place random
place with_program
ecppack --compress with_program/layout.config wanted.bit

"$tools/pack_bitstream.sh" random/layout.config random/contents.hex program.elf found.bit
cmp wanted.bit found.bit || { echo "failed: not the bitstream of the program"; exit 1; }
ecppack --compress random/layout.config random.bit
! cmp -s random.bit found.bit || { echo "failed: the contents make no difference"; exit 1; }

# What cannot be done is refused, and leaves the bitstream that is there.
refuses() {
  ! "$tools/pack_bitstream.sh" "$@" found.bit 2> refused.log || { echo "failed: takes $*"; exit 1; }
  cmp wanted.bit found.bit
}
sed '1,600y/0123456789abcdef/fedcba9876543210/' random/contents.hex > other.hex
refuses random/layout.config other.hex program.elf
refuses with_program/layout.config random/contents.hex program.elf
cat program.bin program.bin > large.bin
riscv64-unknown-elf-objcopy -I binary -O elf32-littleriscv large.bin large.elf
refuses random/layout.config random/contents.hex large.elf
grep -q "larger than the memory" refused.log
echo "compare_packed passed"
