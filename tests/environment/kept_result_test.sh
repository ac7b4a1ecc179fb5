#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A test whose result is kept runs again when anything that it depends on has changed, and after a failure.
# Usage: kept_result_test.sh KEPT_RESULT DIRECTORY
set -euo pipefail
kept_result=$1 directory=$2
rm -rf "$directory"
mkdir -p "$directory/sources"
cd "$directory"
printf '#!/bin/sh\necho run >> runs\nexit "$(cat status)"\n' > program
chmod +x program
touch sources/one data
echo 0 > status

# expect RUNS STATUS WHAT [ARGUMENT...]: so many runs until now, and this status of the last.
expect() {
  local runs=$1 status=$2 what=$3 found=0
  shift 3
  "$kept_result" stamps/test sources -- ./program "$@" || found=$?
  [ "$found" = "$status" ] || { echo "$what: status $found, not $status"; exit 1; }
  [ "$(wc -l < runs)" = "$runs" ] || { echo "$what: $(wc -l < runs) runs, not $runs"; exit 1; }
}

expect 1 0 "the first time" --file=data
expect 1 0 "the same again" --file=data
echo changed > sources/one
expect 2 0 "a changed file of a folder" --file=data
touch sources/two
expect 3 0 "a new file" --file=data
mv sources/two sources/three
expect 4 0 "another name" --file=data
rm sources/three
expect 5 0 "a file less" --file=data
echo changed > data
expect 6 0 "a changed file in the command line" --file=data
echo '# changed' >> program
expect 7 0 "a changed program" --file=data
expect 7 0 "the same again" --file=data
expect 8 0 "another argument" --file=data --other
echo 3 > status
rm stamps/test
expect 9 3 "a failure" --file=data
expect 10 3 "after a failure" --file=data
echo 77 > status
expect 11 77 "left out" --file=data
expect 12 77 "after a test left out" --file=data
echo 0 > status
expect 13 0 "a pass after failures" --file=data
expect 13 0 "the same again" --file=data
echo first > a=b
expect 14 0 "a file whose name has an =" a=b
echo changed > a=b
expect 15 0 "the same file, changed" a=b
export GTEST_FILTER=none
expect 16 0 "other tests" a=b
unset GTEST_FILTER
expect 17 0 "the tests of before" a=b
echo 'echo changed meanwhile >> sources/one' > program_that_changes
sed -i '2i. ./program_that_changes' program
expect 18 0 "a file that changes meanwhile" a=b
expect 19 0 "after a file that has changed meanwhile" a=b
