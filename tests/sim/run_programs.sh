#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# `run` reports how a program ended by its exit status. Usage: run_programs.sh STEPFABRIC MEMORY_BYTES
set -euo pipefail
stepfabric=$1 memory_bytes=$2
# The address so many bytes from the end of the chip's memory.
from_end() { printf '0x%x' $((0x80000000 + memory_bytes - $1)); }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

compile() {
  riscv64-unknown-elf-gcc -march=rv32im_zicsr -mabi=ilp32 -O1 -nostdlib -nostartfiles \
    -Wl,--no-warn-rwx-segments -T "$here/programs.ld" -Wl,--defsym=memory_end="$(from_end 0)" "$@" \
    -o "$work/program.elf"
}

expect() {
  local wanted=$1 status=0
  shift
  "$stepfabric" "$@" > "$work/output" 2>&1 || status=$?
  if [ "$status" != "$wanted" ]; then
    echo "exit status $status instead of $wanted of: stepfabric $*"
    cat "$work/output"
    failures=$((failures + 1))
  fi
}

expect_text() {
  grep -q "$1" "$work/output" || { echo "\"$1\" is not in:"; cat "$work/output"; failures=$((failures + 1)); }
}

program() { compile -DEXIT_VALUE="$1" "$here/programs.S" "$here/programs.c"; }

program 1
expect 0 run "$work/program.elf"
expect_text '^cycles [1-9]'
expect_text '^instructions [1-9]'
program 7
expect 3 run "$work/program.elf"
# The status is the program's, whether its words are read or not.
status=0
"$stepfabric" run "$work/program.elf" --baud 250000 > >(exec true) 2> >(exec true) || status=$?
[ "$status" = 3 ] || { echo "exit status $status where it is not read"; failures=$((failures + 1)); }
# It is not overwritten by what is asked of it.
cp "$work/program.elf" "$work/copy.elf"
expect 125 run "$work/program.elf" --signature "$work/program.elf"
expect_text 'would overwrite'
cmp "$work/program.elf" "$work/copy.elf" || failures=$((failures + 1))
# A program's status is never one of the command's own.
for status in 122 123 124 125 130 255 1000; do
  program $((2 * status + 1))
  expect $((status < 123 ? status : 123)) run "$work/program.elf"
  expect_text "^failed: tohost = $((2 * status + 1)), status $status"
done
program 2
expect 1 run "$work/program.elf"
program 0
expect 124 run "$work/program.elf" --max-cycles 20000
expect_text 'within 20000 cycles: it still runs'

# Programs as the field's tests are: their start-up tries registers that need not be there, `tohost` has 64 bits
# and a page of its own, and it is stored to again and again.
processor_programs=$here/../processor/programs
field_program() {
  riscv64-unknown-elf-gcc -march=rv32imc_zicsr_zifencei -mabi=ilp32 -static -mcmodel=medany -nostdlib \
    -nostartfiles -Wl,--no-warn-rwx-segments -Wa,-I"$processor_programs" \
    -T "$processor_programs/environment.ld" "$@" -o "$work/program.elf"
}
field_body() {
  printf '.include "environment.inc"\nenter\n%b\nleave\n' "$1" > "$work/body.S"
  field_program "${@:2}" "$work/body.S"
}
field_program "$processor_programs/machine_mode.S"
expect 0 run "$work/program.elf"
expect_text '^passed: tohost = 1$'
field_body 'li a0, 1\ncheck a0, 1\ncheck a0, 2'
expect 2 run "$work/program.elf"
expect_text '^failed: tohost = 5, status 2$'
field_body '.word 0'
expect 123 run "$work/program.elf"
expect_text ', status [0-9]*, which the exit status says as 123$'
field_body '1: j 1b'
expect 124 run "$work/program.elf" --max-cycles 1000
field_body 'wfi'
expect 124 run "$work/program.elf" --max-cycles 1000
expect_text 'it sleeps'
field_body 'csrw mtvec, zero\n.word 0'
expect 124 run "$work/program.elf" --max-cycles 1000
expect_text 'completes no instruction any more'
field_body ".data\n.space $memory_bytes\n.text"
expect 125 run "$work/program.elf"
expect_text 'does not fit'

# The signature: words that the program has written, and those that it found; none of a program without one.
field_body 'la a0, begin_signature\nli a1, 0x89abcdef\nsw a1, 4(a0)
.data\n.align 4\n.globl begin_signature, end_signature
begin_signature: .word 0x1234, 0, -1\nend_signature: .text'
expect 0 run "$work/program.elf" --signature "$work/signature"
printf '%s\n' 00001234 89abcdef ffffffff | diff - "$work/signature" || failures=$((failures + 1))
expect 125 run "$work/program.elf" --signature "$work/missing/signature"
expect_text 'cannot write the signature to .*missing/signature'
riscv64-unknown-elf-objcopy --redefine-sym end_signature=other \
  --add-symbol end_signature=0x90000000,global "$work/program.elf"
expect 125 run "$work/program.elf" --signature "$work/signature"
expect_text 'end_signature. at 0x90000000.*no whole words'
field_body 'nop'
expect 125 run "$work/program.elf" --signature "$work/signature"
expect_text 'no symbol .begin_signature'

field_body 'nop' -Wl,--defsym=other=0
riscv64-unknown-elf-objcopy --globalize-symbol=tohost --redefine-sym tohost=elsewhere \
  --add-symbol tohost=0x90000000,global "$work/program.elf"
expect 125 run "$work/program.elf"
expect_text 'tohost.*no memory'

expect 125 run "$work/missing.elf"
expect_text 'No such file'
echo 'G28' > "$work/text.elf"
expect 125 run "$work/text.elf"
expect_text 'is not an ELF file'
expect 125 run /bin/true
expect_text 'not a program for 32-bit RISC-V'
for cycles in none 0 -1 1e99 18446744073709551616; do
  expect 125 run "$work/program.elf" --max-cycles $cycles
  expect_text 'max-cycles'
done
expect 125 run
compile -Wl,--defsym=stack_top="$(from_end 0)" -x assembler - <<< '.globl _start
_start: j _start'
expect 125 run "$work/program.elf"
expect_text 'no symbol `tohost`'

# A program linked without a script: the file's header lies before the memory, and is not loaded.
plain_link() {
  riscv64-unknown-elf-gcc -march=rv32imc_zicsr -mabi=ilp32 -nostdlib -nostartfiles -x assembler "$@" \
    -o "$work/program.elf" - <<< '.globl _start, tohost
_start: la t0, tohost
  li t1, 1
  sw t1, 0(t0)
1: j 1b
  .data
tohost: .word 0
  .section .far, "aw"
  .word 1'
}
plain_link -Wl,-Ttext=0x80000000
expect 0 run "$work/program.elf"
riscv64-unknown-elf-strip "$work/program.elf"
expect 125 run "$work/program.elf"
expect_text 'no symbol `tohost`, as it has no symbols at all'
plain_link -Wl,-Ttext=0x80000100
expect 0 run "$work/program.elf"
plain_link -Wl,-Ttext=0x80000000 -Wl,--section-start=.far="$(from_end 2)"
expect 125 run "$work/program.elf"
expect_text "too large: it loads 4 bytes at $(from_end 2), where.*has room for 2, to $(from_end 1)\$"
plain_link -Wl,-Ttext=0x80000000 -Wl,--section-start=.far="$(from_end 0)"
expect 125 run "$work/program.elf"
expect_text "loads 4 bytes at $(from_end 0).*memory is 0x80000000 to $(from_end 1): link it there"
plain_link -Wl,-Ttext=0x80000000
# The size in memory of a segment such that its end wraps past 2^32.
set_header_word() {
  printf "$(printf '%08x' "$2" | sed 's/\(..\)\(..\)\(..\)\(..\)/\\x\4\\x\3\\x\2\\x\1/')" |
    dd of="$work/program.elf" bs=1 seek="$1" conv=notrunc status=none
}
first_load=$(riscv64-unknown-elf-readelf -lW "$work/program.elf" |
  awk '/^  [A-Z]/ && !/Type/ { if ($1 == "LOAD") { print n; exit } n++ }')
header=$((52 + 32 * first_load))
set_header_word $((header + 12)) 0xfffffff0
set_header_word $((header + 20)) 0x10000
expect 125 run "$work/program.elf"
expect_text 'loads 65536 bytes at 0xfffffff0, beyond the end of the address space'
# Flags of other calling conventions, as in programs for chips with such registers.
for flags in '0x9 RV32E' '0x3 floating-point' '0x5 floating-point' '0x7 floating-point'; do
  plain_link -Wl,-Ttext=0x80000000
  set_header_word 36 "${flags% *}"
  expect 125 run "$work/program.elf"
  expect_text "${flags#* }.*compile it for .*-mabi=ilp32"
done
plain_link -Wl,-Ttext=0x80000000 -Wl,-Tdata=0x80001002
expect 125 run "$work/program.elf"
expect_text 'lies at 0x80001002: align it'
plain_link
expect 125 run "$work/program.elf"
expect_text 'does not fit.*-Ttext=0x80000000'
plain_link -march=rv64imac -mabi=lp64 -mcmodel=medany -Wl,-Ttext=0x80000000
expect 125 run "$work/program.elf"
expect_text 'compile it for -march=rv32imc_zicsr -mabi=ilp32'
expect 125 run "$work"
expect_text 'is a directory'
: > "$work/program.elf"
expect 125 run "$work/program.elf"
expect_text 'is not an ELF file'

# What cannot be printed is reported before anything moves, and the report says it too.
printf 'G28\n\0\n' > "$work/binary.gcode"
: > "$work/empty.gcode"
for case in 'missing does not exist' 'binary is not a G-code file' 'empty holds no G-code command'; do
  expect 2 print "$work/${case%% *}.gcode" --report "$work/report"
  expect_text "${case#* }"
  grep -q '"result": "faulted"' "$work/report/report.json" || { echo "no report of: $case"; failures=1; }
done
for job in bench prove synth; do
  expect 2 "$job" nothing
  expect_text 'nothing'
done
[ "$failures" = 0 ]
