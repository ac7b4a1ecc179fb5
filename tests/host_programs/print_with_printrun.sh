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
. "$here/served_print.sh"

need_printrun

begin_in_folder
write_job 40 'M117 Layer %d G1 X5*\nM105\n'
print_alone
# The job's lines as the firmware must take them: with the numbers of printcore, from 0.
lines_of_job | awk '{ print NR - 1 "\t" $0 }' > wanted

# serve_and_print NAME CLIENT [CABLE_OPTION...]: CLIENT.py prints, with such options over a bad cable.
serve_and_print() {
  local name=$1 client=$2
  shift 2
  begin_to_serve "$name" "$@"
  python3 -W ignore "$here/$client.py" "$job" "$port" --summary "$name.json" \
    > "$name.client.log" 2>&1 || echo "$client ended with status $?" > "$name.failed"
  end_serving "$name"
}

same_lines() { taken "$1" | cmp - wanted || fail "$1: the lines taken are not those of the file"; }

for client in printcore pronsole; do
  serve_and_print "$client" "print_with_$client"
  [ ! -e "$client.failed" ] || fail "$(cat "$client.failed"), see $folder/$client.json"
  grep -q ' 0 resends' "$client.log" || fail "$client: resends on a good line"
  same_lines "$client"
  same_pulses "$client"
done

speed=real
# printcore itself calls a resend an error, so its status does not count here.
serve_and_print noisy print_with_printcore --faults 0.003 --ascii-up \
  --stall-every 900 --disconnect-every 500 --seed 3
grep -q ' 0 resends' noisy.log && fail "the bad line was not bad"
same_lines noisy
same_pulses noisy
echo "printed with printcore, pronsole, and printcore over a bad line: $(cat noisy.cable)"
