#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Draws the pictures of this folder from the pins of the Verilated step generator.
# Usage: tools/environment/enter.sh rtl/motion/pictures/draw.sh build/bin/step_generator_traces
set -euo pipefail
program=$1
pictures=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
tables=$(mktemp -d)
trap 'rm -rf "$tables"' EXIT
"$program" "$tables"
cd "$tables"
gnuplot -e "pictures='$pictures'" "$pictures/pictures.gnuplot"
