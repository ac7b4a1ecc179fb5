#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints with the real printcore and pronsole of Printrun through `stepfabric serve`: over a good line no
# resend, every line taken once and in order, and the same pulses as of `stepfabric print`; over a bad one,
# which also stalls and is unplugged, the same lines and pulses. Usage: print_with_printrun.sh STEPFABRIC
# FOLDER. Status 77: there is no Printrun here.
set -euo pipefail
stepfabric=$1
folder=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)

# The tool root shows the host's Python packages under /run/host_python.
[ ! -d /run/host_python/printrun ] || export PYTHONPATH=/run/host_python
if ! python3 -W ignore -c 'import printrun.printcore' 2>/dev/null; then
  echo "SKIPPED: no Printrun on this machine, so the real printcore and pronsole were NOT tried." >&2
  echo "On Debian 12: apt-get install --no-install-recommends printrun" >&2
  exit 77
fi

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
job=$folder/job.gcode
{
  printf '; comment\nG28 X Y\nG90\nM82\nG92 E0\nG1 F6000\n'
  for i in $(seq 1 40); do
    printf 'G1 X%d.%d Y%d.25 ; line %d\n' $((5 + i % 7)) $((i % 10)) $((6 + i * 3 % 5)) "$i"
    [ $((i % 10)) != 0 ] || printf 'M117 Layer %d G1 X5*\nM105\n' "$i"
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

# serve_and_print NAME PORT CLIENT [CABLE_OPTION...]: the printer on NAME.port, CLIENT.py on PORT.
serve_and_print() {
  local name=$1 port=$2 client=$3
  shift 3
  "$stepfabric" serve --speed max --pty "$folder/$name.port" --report "$folder/$name.report" \
    --edges "$folder/$name.edges" --accept-log "$folder/$name.accept" > "$name.log" 2>&1 &
  server=$!
  wait_for_link "$folder/$name.port"
  if [ "$port" != "$name.port" ]; then
    python3 "$here/noisy_port.py" "$folder/$name.port" "$folder/$port" "$@" > "$name.cable" &
    cable=$!
    wait_for_link "$folder/$port"
  fi
  python3 -W ignore "$here/$client.py" "$job" "$folder/$port" --summary "$name.json" \
    > "$name.client.log" 2>&1 || echo "$client ended with status $?" > "$name.failed"
  if [ -n "$cable" ]; then
    kill "$cable"
    wait "$cable" || true
    cable=
  fi
  kill "$server"
  wait "$server" || fail "serve did not end well, see $folder/$name.log"
  server=
}

# The job's lines as the firmware must take them: with the numbers of printcore, from 0.
grep -v '^;' "$job" | sed 's/ *;.*//' | awk '{ print NR - 1 "\t" $0 }' > wanted

taken() { grep -v -P '^(-|-1)\t' "$1.accept" | grep -v -P '\tM110' || true; }
same_lines() { taken "$1" | cmp - wanted || fail "$1: the lines taken are not those of the file"; }
same_pulses() {
  cut -d, -f2- "$1.edges" | cmp - printed || fail "$1: the pulses are not those of \`print\`"
}

"$stepfabric" print "$job" --report print.report --edges print.edges > print.log 2>&1 ||
  fail "print, see $folder/print.log"
cut -d, -f2- print.edges > printed
[ "$(wc -l < printed)" -gt 10000 ] || fail "print made hardly any pulse"

for client in printcore pronsole; do
  serve_and_print "$client" "$client.port" "print_with_$client"
  [ ! -e "$client.failed" ] || fail "$(cat "$client.failed"), see $folder/$client.json"
  grep -q ' 0 resends' "$client.log" || fail "$client: resends on a good line"
  same_lines "$client"
  same_pulses "$client"
done

# printcore itself calls a resend an error, so its status does not count here.
serve_and_print noisy noisy.cable_port print_with_printcore --faults 0.003 --ascii-up \
  --stall-every 900 --disconnect-every 500 --seed 3
grep -q ' 0 resends' noisy.log && fail "the bad line was not bad"
same_lines noisy
same_pulses noisy
echo "printed with printcore, pronsole, and printcore over a bad line: $(cat noisy.cable)"
