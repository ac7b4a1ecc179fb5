#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Usage: reserved_registers.sh FOLDER IMAGE...
# In these images no instruction but the tick's touches the registers that the tick keeps between
# interrupts: not the compiler's, not one of a library that was compiled without knowing of them.
set -eu

folder=$1
shift
status=0

# Address of a symbol.
address_of() {
  riscv64-unknown-elf-nm "$1" | awk -v symbol="$2" '$3 == symbol { print "0x" $1 }'
}

for image in "$@"; do
  elf=$folder/$image
  first=$(address_of "$elf" tick_code_begins)
  end=$(address_of "$elf" tick_code_ends)
  code_end=$(address_of "$elf" _code_end)
  if [ -z "$first" ] || [ -z "$end" ] || [ -z "$code_end" ]; then
    echo "$image: tick_code_begins, tick_code_ends (tick.S) or _code_end (image.ld) is missing" >&2
    exit 1
  fi
  for part in "0x80000000 $first others" "$first $end tick" "$end $code_end others"; do
    set -- $part "$@"
    riscv64-unknown-elf-objdump -d --no-show-raw-insn "$elf" \
      --start-address="$1" --stop-address="$2" | sed "s/^/$3 /"
    shift 3
  done | awk -v image="$image" '
    BEGIN { reserved = "(^|[,( \t])(tp|t2|t3|t4|t5|t6|s7|s8|s9|s10|s11)([,) \t]|$)" }
    / <.*>:$/ { name = $3; sub(/^</, "", name); sub(/>:$/, "", name); next }
    $2 !~ /^[0-9a-f]+:$/ { next }
    {
      ++instructions
      text = $0
      sub(/^[a-z]+ +[0-9a-f]+:[ \t]+[^ \t]+/, "", text)
      # The compiler'"'"'s routines for functions with more saved registers than are left: linked, not called.
      if (text ~ /<__riscv_(save|restore)_1[0-2]/ && name !~ /^__riscv_(save|restore)_1[0-2]$/) {
        print image ": " name " saves and restores reserved registers: " $0 " (compile it with -ffixed-..., firmware/target)"
        faults = 1
      }
      sub(/[ \t]*[#<].*/, "", text)
      if (text !~ reserved) next
      if ($1 == "tick") { ++uses; next }
      if (name ~ /^__riscv_(save|restore)_1[0-2]$/) next
      print image ": " name " touches a register of the tick: " $0 \
        " (compile it with -ffixed-..., or give the image its own, firmware/target)"
      faults = 1
    }
    END {
      if (uses < 50) { print image ": only " uses + 0 " instructions of the tick were recognised"; faults = 1 }
      print image ": " instructions " instructions, " uses " of the tick on its registers"
      exit faults
    }' || status=1
done
exit $status
