#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs a test, or passes at once where the same test has passed with the same contents. The contents are those of the
# paths, of all files below them, and of every file in the command line; the command line counts, too, and variables that
# choose tests or their length. What changes while the test runs leaves no result.
# Usage: kept_result.sh STAMP PATH... -- COMMAND...
set -euo pipefail
stamp=$1
shift
paths=()
while [ "$1" != -- ]; do
  paths+=("$1")
  shift
done
shift
for word in "$@"; do
  for name in "$word" "${word#*=}"; do
    [ ! -f "$name" ] || paths+=("$name")
  done
done

contents() {
  printf '%s\n' "$@"
  env | LC_ALL=C sort | grep -E '^(GTEST_|STEP_GENERATOR_|STEPFABRIC_QEMU_)' || true
  [ "${#paths[@]}" -eq 0 ] || find -L "${paths[@]}" -type f -print0 | LC_ALL=C sort -zu | xargs -0 sha256sum
}
key=$(contents "$@" | sha256sum)

if [ -f "$stamp" ] && [ "$(< "$stamp")" = "$key" ]; then
  echo "passed before with the same contents; without $stamp it runs again"
  exit 0
fi
"$@"
if [ "$(contents "$@" | sha256sum)" != "$key" ]; then
  echo "not kept: what it reads has changed meanwhile"
  exit 0
fi
mkdir -p "$(dirname "$stamp")"
printf '%s\n' "$key" > "$stamp.new"
mv "$stamp.new" "$stamp"
