#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The real printcore of Printrun through `stepfabric serve`, with 1 % of the bytes damaged in both directions: it
# gets to the end, and each line is taken once and in order. Only lines whose checksum is right though two bytes
# are wrong may differ, and are named. Usage: print_very_noisy.sh STEPFABRIC FOLDER [MOVES [SEED]]. Status 77:
# there is no Printrun here.
set -euo pipefail
stepfabric=$1
folder=$2
moves=${3:-300}
seed=${4:-7}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
. "$here/served_print.sh"
need_printrun

begin_in_folder
write_job "$moves"
lines_of_job | awk '{ print NR - 1 "\t" $0 }' > wanted
begin_to_serve very_noisy --faults 0.01 --ascii-up --seed "$seed"
# printcore calls a resend an error, so its status does not count here; the lines taken do.
python3 -W ignore "$here/print_with_printcore.py" "$job" "$port" --timeout 300 --summary very_noisy.json \
  > client.log 2>&1 || true
end_serving very_noisy
grep -q '"ended": true' very_noisy.json || fail "printcore did not get to the end, see $folder/very_noisy.json"
grep -q ' 0 resends' very_noisy.log && fail "the bad line was not bad"
taken very_noisy > lines_taken
python3 "$here/lines_that_lie.py" lines_taken wanted || fail "see above"
cat very_noisy.cable
