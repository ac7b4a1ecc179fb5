#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the pictures of this folder: prints two files, and takes screenshots of their reports with Chromium
# (Debian: chromium; pngquant makes them small). Fails where the page's scripts complain.
# Usage: sim/report/pictures/make.sh [FOLDER]   (FOLDER: reports made before, washer/ and wrong/, or a place for them)
set -euo pipefail
pictures=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
project=$(cd "$pictures/../../.." && pwd -P)
for program in chromium pngquant; do
  command -v "$program" > /dev/null || { echo "make.sh: $program is missing" >&2; exit 1; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
reports=$(realpath -m "${1:-$scratch/reports}")

print_file() {  # NAME FILE
  if [[ ! -f $reports/$1/report.html ]]; then
    # A print that goes wrong ends with another status than 0, and has a report.
    "$project/stepfabric" print "$2" --warm --report "$reports/$1" || [[ -f $reports/$1/report.html ]]
  fi
}

screenshot() {  # PICTURE REPORT?VIEW WIDTH HEIGHT THEME
  local -A theme=([dark]=0 [light]=1)
  timeout 60 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --force-color-profile=srgb \
    --user-data-dir="$scratch/profile_$1" --enable-logging=stderr --virtual-time-budget=5000 \
    --blink-settings="preferredColorScheme=${theme[$5]}" --window-size="$3,$4" \
    --screenshot="$scratch/$1.png" "file://$reports/$2" 2> "$scratch/log" || { cat "$scratch/log" >&2; exit 1; }
  if grep CONSOLE "$scratch/log" >&2; then
    echo "make.sh: the scripts of $2 complain" >&2
    exit 1
  fi
  pngquant --force --strip --quality 60-95 --output "$pictures/$1.png" 64 "$scratch/$1.png"
}

print_file washer "$project/examples/washer.gcode"
print_file wrong "$pictures/wrong.gcode"
screenshot good "washer/report.html?in-space" 1240 1230 light
screenshot wrong "wrong/report.html" 1240 1690 dark
screenshot courses "washer/report.html?only=speeds&from=58&to=64" 1240 460 light
screenshot phone "wrong/report.html" 390 1560 light
ls -l "$pictures"/*.png
