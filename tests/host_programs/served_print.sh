#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# For the scripts that print with a host's own program: a job, the chip's pulses for it, a served chip and a bad
# cable. To be sourced by a script whose `stepfabric`, `folder` and `here` name the program, an empty place for
# files and this folder.

server=
cable=
port=
# Of the served chip. A pause of the cable is a pause in real time, to a chip at `max` it is many times longer.
speed=max
job=$folder/job.gcode

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# Ends the script with status 77 where Printrun is missing.
need_printrun() {
  # The tool root shows the host's Python packages under /run/host_python.
  [ ! -d /run/host_python/printrun ] || export PYTHONPATH=/run/host_python
  if ! python3 -W ignore -c 'import printrun.printcore' 2>/dev/null; then
    echo "SKIPPED: no Printrun on this machine, so the real printcore and pronsole were NOT tried." >&2
    echo "On Debian 12: apt-get install --no-install-recommends printrun" >&2
    exit 77
  fi
}

end_programs() {
  [ -z "$cable" ] || kill "$cable" 2>/dev/null || true
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
  wait
}

# Makes the folder and goes there; what is started is ended with the script.
begin_in_folder() {
  rm -rf "$folder"
  mkdir -p "$folder"
  cd "$folder"
  trap end_programs EXIT
}

# write_job MOVES [TEXT]: so many moves in a file; after each tenth one the text, with its number in place of %d.
write_job() {
  {
    printf '; comment\nG28 X Y\nG90\nM82\nG92 E0\nG1 F6000\n'
    for i in $(seq 1 "$1"); do
      printf 'G1 X%d.%d Y%d.25 ; line %d\n' $((5 + i % 7)) $((i % 10)) $((6 + i * 3 % 5)) "$i"
      # shellcheck disable=SC2059
      [ $((i % 10)) != 0 ] || [ -z "${2-}" ] || printf "$2" "$i"
    done
    printf 'G1 X0.5Y0\nM84\n'
  } > "$job"
}

# The lines of the job without comments.
lines_of_job() { grep -v '^;' "$job" | sed 's/ *;.*//'; }

# The pulses of `print`, with which those of `serve` are compared.
print_alone() {
  "$stepfabric" print "$job" --report print.report --edges print.edges > print.log 2>&1 ||
    fail "print, see $folder/print.log"
  cut -d, -f2- print.edges > printed
  [ "$(wc -l < printed)" -gt 10000 ] || fail "print made hardly any pulse"
}
same_pulses() {
  cut -d, -f2- "$1.edges" | cmp - printed || fail "$1: the pulses are not those of \`print\`"
}

wait_for_link() {
  for _ in $(seq 1 600); do
    [ ! -L "$1" ] || return 0
    sleep 0.1
  done
  fail "$1 does not appear"
}

# begin_to_serve NAME [CABLE_OPTION...]: the chip is at $port, with such options behind a bad cable.
begin_to_serve() {
  local name=$1
  port=$folder/$name.port
  shift
  "$stepfabric" serve --speed "$speed" --pty "$port" --report "$name.report" \
    --edges "$name.edges" --accept-log "$name.accept" > "$name.log" 2>&1 &
  server=$!
  wait_for_link "$port"
  if [ $# != 0 ]; then
    port=$folder/$name.cable_port
    python3 "$here/noisy_port.py" "$folder/$name.port" "$port" "$@" > "$name.cable" &
    cable=$!
    wait_for_link "$port"
  fi
}

end_serving() {
  if [ -n "$cable" ]; then
    kill "$cable"
    wait "$cable" || true
    cable=
  fi
  kill "$server"
  wait "$server" || fail "serve did not end well, see $folder/$1.log"
  server=
}

# taken NAME: number and text of the lines that the firmware has taken, but for the M110 of the hosts.
taken() { grep -v -P '^(-|-1)\t' "$1.accept" | grep -v -P '\tM110' || true; }
