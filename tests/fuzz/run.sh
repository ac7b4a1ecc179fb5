#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Gives a fuzz program its kept corpus and new inputs, the same in each call. An input that violates a
# property is left in findings/ next to the programs' folder.
# Usage: run.sh PROGRAM CORPUS EXECUTIONS
set -euo pipefail
program=$1 corpus=$2 executions=$3
findings=$(dirname "$program")/../findings
mkdir -p "$findings"
new=$(mktemp -d)
trap 'rm -rf "$new"' EXIT
"$program" -seed=1 -runs="$executions" -artifact_prefix="$findings/${program##*/}-" "$new" "$corpus"
