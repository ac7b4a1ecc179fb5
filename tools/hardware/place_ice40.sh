#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What synthesize_ice40.sh has left in NETLIST_DIRECTORY on an iCE40: netlist -> (nextpnr) -> report.json in the
# directory.
# Usage: place_ice40.sh PROJECT BOARD NETLIST_DIRECTORY DEVICE SEED DIRECTORY
set -euo pipefail
project=$1 board=$2 netlist=$3/netlist.json device=$4 seed=$5 directory=$6
. "$project/tools/hardware/steps.sh"

case $device in
  hx8k) package=ct256 ;;
  up5k) package=sg48 ;;
  *) echo "failed: no iCE40 is called $device" >&2; exit 1 ;;
esac
mkdir -p "$directory"
cd "$directory"
rm -f report.json
place nextpnr-ice40 "--$device" --package "$package" --json "$netlist" \
  --pcf "$project/constraints/${board}_$device.pcf" --pcf-allow-unconstrained \
  --report report.json --seed "$seed" --timing-allow-fail
