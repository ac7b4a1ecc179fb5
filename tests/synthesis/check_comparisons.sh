#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Proves that tools/hardware/ecp5_compare_map.v changes no comparison, and that it leaves none with a constant.
# Usage: check_comparisons.sh PROJECT
set -euo pipefail
yosys -q -p "read_verilog -sv $1/tests/synthesis/comparisons.sv;
  hierarchy -top comparisons; proc; flatten; opt_clean;
  copy comparisons mapped; cd mapped;
  select -assert-min 900 t:\$lt t:\$le t:\$gt t:\$ge;
  techmap -map $1/tools/hardware/ecp5_compare_map.v; opt_clean;
  select -assert-count 1 t:\$lt t:\$le t:\$gt t:\$ge; select -clear;
  cd ..;
  miter -equiv -flatten comparisons mapped pair; hierarchy -top pair;
  sat -prove trigger 0 -verify pair" > /dev/null
echo "every comparison with a constant keeps its meaning"
