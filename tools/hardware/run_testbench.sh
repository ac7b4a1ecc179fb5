#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Analyses and runs one GHDL test bench; the properties of testbench/proofs watch the architectures, unless
# --without-properties is given. Usage: run_testbench.sh [--without-properties] WORK_DIRECTORY BENCH PROJECT [-gNAME=VALUE...]
set -euo pipefail
properties=yes
if [ "$1" = --without-properties ]; then
  properties=no
  shift
fi
work=$1 bench=$2 project=$3
shift 3
rm -rf "$work"
mkdir -p "$work"
cd "$work"
options=(--std=08 --workdir="$work")
rtl=$project/rtl
if [ $properties = yes ]; then
  options+=(-fpsl)
  rtl=$work/rtl
  "$project/tools/hardware/weave_properties.sh" "$project/rtl" "$project/testbench/proofs" "$rtl" simulation
fi
mapfile -t files < <(find "$rtl" "$project/boards" "$project/testbench" -name '*.vhd' | sort)
ghdl -i "${options[@]}" "${files[@]}"
ghdl -m "${options[@]}" "$bench" > make.log || { cat make.log; exit 1; }
ghdl -r "${options[@]}" "$bench" "$@" --assert-level=error --backtrace-severity=error | tee run.log
# Where nothing settles, or nothing happens any more, GHDL ends without an error.
grep -q '^simulation finished' run.log || { echo "$bench does not finish"; exit 1; }
