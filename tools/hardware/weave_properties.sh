#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copies the chip's sources and puts each verification unit (*.psl) into its architecture as a block, because
# GHDL binds verification units in synthesis only: so simulation, netlist and proof see the same text.
# Usage: weave_properties.sh RTL_FOLDER PROPERTIES_FOLDER OUTPUT_FOLDER [simulation]
# For simulation, units that say "Not for simulation" are left out.
set -euo pipefail
rtl=$1 properties=$2 output=$3
mkdir -p "$output"
cp -r "$rtl/." "$output"

mapfile -t units < <(find "$properties" -name '*.psl' | sort)
for unit in "${units[@]}"; do
  if [ "${4-}" = simulation ] && grep -q '^--.*Not for simulation' "$unit"; then continue; fi
  entity=$(sed -n 's/^vunit \w* (\(\w*\)(rtl)) {$/\1/p' "$unit")
  file=$(find "$output" -name "$entity.vhd")
  if [ -z "$entity" ] || [ ! -f "$file" ]; then
    echo "$unit: no line \"vunit NAME (ENTITY(rtl)) {\" with the entity of one file" >&2
    exit 1
  fi
  # The unit's declarations come first, its statements begin at the first label.
  awk -v unit="$unit" '
    BEGIN {
      while ((getline line < unit) > 0) {
        if (line ~ /^vunit /) {
          split(line, words, " ")
          block = "  " words[2] " : block\n"
          inside = 1
        } else if (line ~ /^}/) {
          inside = 0
        } else if (inside) {
          if (!begun && line ~ /^  [a-z_0-9]+ : /) { block = block "  begin\n"; begun = 1 }
          block = block line "\n"
        }
      }
      if (!begun) { print unit ": no labelled statement" > "/dev/stderr"; exit 1 }
    }
    /^end architecture;/ { printf "%s  end block;\n\n", block }
    { print }
  ' "$file" > "$file.woven"
  mv "$file.woven" "$file"
done
