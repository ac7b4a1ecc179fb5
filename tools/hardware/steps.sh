# SPDX-License-Identifier: Apache-2.0
# How the scripts of a synthesis call a tool: its output goes to a log, and if it fails the end of
# the log is shown. Sourced, with `directory` set and entered.

# step LOG COMMAND [ARGUMENT...]
step() {
  local log=$1
  shift
  "$@" > "$log" 2>&1 || { tail -n 20 "$log" >&2; echo "failed: $1; log in $directory/$log" >&2; exit 1; }
}

# place NEXTPNR [ARGUMENT...]: the same; if the device is too small, the resource that runs out is
# reported in place of nextpnr's message, which names a single cell.
place() {
  "$@" > nextpnr.log 2>&1 && return
  awk '/[0-9]+\/ *[0-9]+ +[0-9]+%$/ {
      percent = $NF
      sub(/%/, "", percent)
      if (percent > 100) { sub(/^Info:[ \t]*/, ""); rows = rows "  " $0 "\n" }
    }
    END { if (rows == "") exit 1; printf "the design does not fit into this device; a larger one is wanted (--device):\n%s", rows }
  ' nextpnr.log >&2 || tail -n 20 nextpnr.log >&2
  echo "failed: $1; log in $directory/nextpnr.log" >&2
  exit 1
}
