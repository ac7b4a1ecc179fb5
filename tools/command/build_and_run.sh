#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Inside the tool root: builds the `stepfabric` program (incrementally) and runs it.
set -euo pipefail
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
build=${STEPFABRIC_BUILD_DIR:-$project/build}
log=$build/build.log
mkdir -p "$build"
export STEPFABRIC_BUILD_DIR=$build

# Two concurrent calls must not build into the same folder.
exec 8>"$build/lock"
flock 8
started=$SECONDS
fresh=$([ -f "$build/bin/stepfabric" ] || echo yes)
[ -z "$fresh" ] || echo "stepfabric: building for the first time: about 3 minutes, log in $log" >&2
{
  [ -f "$build/CMakeCache.txt" ] ||
    cmake -S "$project" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release
  cmake --build "$build" --target stepfabric
} > "$log" 2>&1 || {
  tail -n 40 "$log" >&2
  echo "stepfabric: the build failed; the whole log is in $log" >&2
  # Lower statuses are those of the program executed by `run`.
  [ "${1-}" != run ] || exit 125
  exit 1
}
[ -z "$fresh" ] || echo "stepfabric: built in $((SECONDS - started)) s" >&2
flock -u 8
exec 8>&-
exec "$build/bin/stepfabric" "$@"
