#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Analyses and runs one GHDL test bench; the properties of testbench/proofs watch the architectures.
# Usage: run_testbench.sh WORK_DIRECTORY BENCH PROJECT [-gNAME=VALUE...]
set -euo pipefail
work=$1 bench=$2 project=$3
shift 3
rm -rf "$work"
mkdir -p "$work"
cd "$work"
options=(--std=08 -fpsl --workdir="$work")
"$project/tools/hardware/weave_properties.sh" "$project/rtl" "$project/testbench/proofs" \
  "$work/rtl" simulation
mapfile -t files < <(find "$work/rtl" "$project/testbench" -name '*.vhd' | sort)
ghdl -i "${options[@]}" "${files[@]}"
ghdl -m "${options[@]}" "$bench" > make.log || { cat make.log; exit 1; }
exec ghdl -r "${options[@]}" "$bench" "$@" --assert-level=error --backtrace-severity=error
