#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints with Cura's own USB device through `stepfabric serve`, over a good line and over a bad one: each line
# taken once and in order, and the same pulses as of `stepfabric print`. Usage: print_with_cura.sh STEPFABRIC
# FOLDER. STEPFABRIC_CURA: the folder of the plugin USBPrinting, where it is not at its usual place. Status 77:
# there is no Cura here.
set -euo pipefail
stepfabric=$1
folder=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)

# The tool root shows the host's Cura and Python packages under /run.
[ ! -d /run/host_python/serial ] || export PYTHONPATH=/run/host_python${PYTHONPATH:+:$PYTHONPATH}
plugin=
for place in "${STEPFABRIC_CURA:-}" /run/host_cura/plugins/USBPrinting /usr/lib/cura/plugins/USBPrinting; do
  [ -n "$plugin" ] || [ ! -f "$place/USBPrinterOutputDevice.py" ] || plugin=$place
done
if [ -z "$plugin" ] || ! python3 -c 'import serial' 2>/dev/null; then
  echo "SKIPPED: no Cura, or no pyserial, on this machine, so Cura's own USB device was NOT tried." >&2
  echo "On Debian 12 and 13: apt-get install --no-install-recommends cura" >&2
  exit 77
fi

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
job=$folder/job.gcode
{
  printf '; comment\nG28 X Y\nG90\nM82\nG92 E0\nG1 F6000\n'
  for i in $(seq 1 60); do
    printf 'G1 X%d.%d Y%d.25 ; line %d\n' $((5 + i % 7)) $((i % 10)) $((6 + i * 3 % 5)) "$i"
  done
  printf 'G1 X0.5Y0\nM84\n'
} > "$job"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

server=
cable=
end_programs() {
  [ -z "$cable" ] || kill "$cable" 2>/dev/null || true
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
  wait
}
trap end_programs EXIT

wait_for_link() {
  for _ in $(seq 1 600); do
    [ ! -L "$1" ] || return 0
    sleep 0.1
  done
  fail "$1 does not appear"
}

"$stepfabric" print "$job" --report print.report --edges print.edges > print.log 2>&1 ||
  fail "print, see $folder/print.log"
cut -d, -f2- print.edges > printed
[ "$(wc -l < printed)" -gt 10000 ] || fail "print made hardly any pulse"
grep -v '^;' "$job" | sed 's/ *;.*//' > wanted

# serve_and_print NAME [CABLE_OPTION...]: with such options over a bad cable.
serve_and_print() {
  local name=$1 port=$1.port
  shift
  "$stepfabric" serve --speed max --pty "$folder/$name.port" --report "$name.report" \
    --edges "$name.edges" --accept-log "$name.accept" > "$name.log" 2>&1 &
  server=$!
  wait_for_link "$folder/$name.port"
  if [ $# != 0 ]; then
    port=$name.cable_port
    python3 "$here/noisy_port.py" "$folder/$name.port" "$folder/$port" "$@" > "$name.cable" &
    cable=$!
    wait_for_link "$folder/$port"
  fi
  python3 -W ignore "$here/print_with_cura.py" "$job" "$folder/$port" --plugin "$plugin" \
    --summary "$name.json" > "$name.client.log" 2>&1 ||
    fail "$name: Cura's device did not end its print, see $folder/$name.json and $name.client.log"
  if [ -n "$cable" ]; then
    kill "$cable"
    wait "$cable" || true
    cable=
  fi
  kill "$server"
  wait "$server" || fail "serve did not end well, see $folder/$name.log"
  server=
  # Cura sends M110 before the first line, and M105 for what is empty without its comment.
  { grep -P '^\d+\t' "$name.accept" || true; } | cut -f2 | { grep -v -P '^M(105|110)' || true; } |
    cmp - wanted || fail "$name: the lines taken are not those of the file"
  cut -d, -f2- "$name.edges" | cmp - printed || fail "$name: the pulses are not those of \`print\`"
}

serve_and_print good
grep -q ' 0 resends' good.log || fail "resends on a good line"
serve_and_print noisy --faults 0.003 --seed 3
grep -q ' 0 resends' noisy.log && fail "the bad line was not bad"
echo "printed with Cura's USB device: $(tr -d '\n' < good.json); over a bad line: $(cat noisy.cable)"
