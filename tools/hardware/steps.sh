# SPDX-License-Identifier: Apache-2.0
# How the scripts of a synthesis call a tool: its words go to a log, and where it fails the last of them are shown.
# Sourced, with `directory` set and entered.

# step LOG COMMAND [ARGUMENT...]
step() {
  local log=$1
  shift
  "$@" > "$log" 2>&1 || { tail -n 20 "$log" >&2; echo "failed: $1; log in $directory/$log" >&2; exit 1; }
}

# place NEXTPNR [ARGUMENT...]: the same; what the device has too little of is reported in place of nextpnr's words, which
# name one cell that finds no room.
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
