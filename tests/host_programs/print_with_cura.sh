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
. "$here/served_print.sh"

# The tool root shows the host's Cura and Python packages under /run.
[ ! -d /run/host_python/serial ] || export PYTHONPATH=${PYTHONPATH:+$PYTHONPATH:}/run/host_python
plugin=
for place in "${STEPFABRIC_CURA:-}" /run/host_cura/plugins/USBPrinting /usr/lib/cura/plugins/USBPrinting; do
  [ -n "$plugin" ] || [ ! -f "$place/USBPrinterOutputDevice.py" ] || plugin=$place
done
if [ -z "$plugin" ] || ! python3 -c 'import serial' 2>/dev/null; then
  echo "SKIPPED: no Cura, or no pyserial, on this machine, so Cura's own USB device was NOT tried." >&2
  echo "On Debian 12 and 13: apt-get install --no-install-recommends cura" >&2
  exit 77
fi

begin_in_folder
write_job 60
print_alone
lines_of_job > wanted

# serve_and_print NAME [CABLE_OPTION...]: with such options over a bad cable.
serve_and_print() {
  local name=$1
  begin_to_serve "$@"
  python3 -W ignore "$here/print_with_cura.py" "$job" "$port" --plugin "$plugin" \
    --summary "$name.json" > "$name.client.log" 2>&1 ||
    fail "$name: Cura's device did not end its print, see $folder/$name.json and $name.client.log"
  end_serving "$name"
  # Cura sends M110 before the first line, and M105 for what is empty without its comment.
  { grep -P '^\d+\t' "$name.accept" || true; } | cut -f2 | { grep -v -P '^M(105|110)' || true; } |
    cmp - wanted || fail "$name: the lines taken are not those of the file"
  same_pulses "$name"
}

serve_and_print good
grep -q ' 0 resends' good.log || fail "resends on a good line"
serve_and_print noisy --faults 0.003 --seed 3
grep -q ' 0 resends' noisy.log && fail "the bad line was not bad"
echo "printed with Cura's USB device: $(tr -d '\n' < good.json); over a bad line: $(cat noisy.cable)"
