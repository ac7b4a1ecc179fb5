#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A layout of nextpnr and a program -> (ecpbram, ecppack) -> bitstream with the program in the memory, in seconds. CONTENTS.hex
# are the random words that the layout has there (synthesize_board.sh).
# Usage: pack_bitstream.sh LAYOUT.config CONTENTS.hex PROGRAM.elf BITSTREAM.bit
set -euo pipefail
layout=$1 contents=$2 program=$3 bitstream=$4

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "failed: $*" >&2; exit 1; }

# A word of 32 bits a line, the rest of the memory zero.
riscv64-unknown-elf-objcopy -O binary "$program" "$work/program.bin"
words=$(wc -l < "$contents")
[ "$(stat -c %s "$work/program.bin")" -le $((4 * words)) ] || fail "the program is larger than the memory"
od -An -v -tx1 -w4 "$work/program.bin" |
  awk -v words="$words" '
    function byte(text) { return text == "" ? "00" : text }
    { print byte($4) byte($3) byte($2) byte($1) }
    END { for (i = NR; i < words; i++) print "00000000" }' > "$work/program.hex"

ecpbram --input "$layout" --output "$work/packed.config" --from "$contents" --to "$work/program.hex"

# ecpbram does not say what it has not found: the bits that are set must have become as many more or fewer as the program
# has more or fewer than the random words.
bits_in() {
  awk -v only_memories="$2" '
    BEGIN { split("0 1 1 2 1 2 2 3 1 2 2 3 2 3 3 4", bits, " ") }
    /^\./ { inside = /^\.bram_init / ; next }
    inside || !only_memories {
      for (i = 1; i <= length($0); i++) {
        digit = index("0123456789abcdef", substr($0, i, 1))
        if (digit) count += bits[digit]
      }
    }
    END { print count + 0 }' "$1"
}
[ $(($(bits_in "$work/packed.config" 1) - $(bits_in "$layout" 1))) = \
  $(($(bits_in "$work/program.hex" 0) - $(bits_in "$contents" 0))) ] ||
  fail "$layout has not the contents of $contents in its memory"

ecppack --compress "$work/packed.config" "$work/packed.bit"
mv "$work/packed.bit" "$bitstream"
