#!/usr/bin/env bash
# Runs a command with the project's tools: this machine's own where they are new enough, otherwise those
# of a Debian 13 tool root. Usage: enter.sh COMMAND [ARGUMENT...]. SPDX-License-Identifier: Apache-2.0
set -euo pipefail
environment=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
project=$(cd "$environment/../.." && pwd -P)

say() { printf 'stepfabric: %s\n' "$*" >&2; }

. "$environment/native_tools.sh"
. "$environment/host_packages.sh"
. "$environment/tool_root.sh"

# The host's folders that a command inside the root must see under their own names: everything that
# a user keeps files in, but none of the folders in which programs and their settings lie.
visible_host_folders() {
  local entry
  for entry in /*; do
    case $entry in
      /bin|/boot|/dev|/etc|/lib*|/lost+found|/proc|/run|/sbin|/sys|/usr|/var) continue ;;
    esac
    [ -d "$entry" ] && [ ! -L "$entry" ] && echo "$entry"
  done
  for entry in "$project" "$PWD" "${XDG_RUNTIME_DIR:-}"; do
    [ -d "$entry" ] || continue
    case $entry in
      /usr/*|/var/*|/etc/*|/run/*) echo "$entry" ;;
    esac
  done
}

# Printrun is not in Debian 13, and Cura is large. Where the host has them, their tests find them and their parts here.
host_python=/usr/lib/python3/dist-packages
inner_host_python=/run/host_python
host_cura=/usr/lib/cura
inner_host_cura=/run/host_cura

# All clones on a machine share what the compiler's cache holds: it sees paths relative to the project.
export CCACHE_BASEDIR=${CCACHE_BASEDIR-$project} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR-true}

# The environment inside: a fixed path and language, and what a user sets on purpose.
inner_environment() {
  local name
  echo "PATH=/usr/sbin:/usr/bin:/sbin:/bin"
  echo "LANG=C.UTF-8"
  for name in HOME USER TERM COLUMNS CI NO_COLOR CTEST_OUTPUT_ON_FAILURE CCACHE_DIR CCACHE_MAXSIZE \
    CCACHE_BASEDIR CCACHE_NOHASHDIR \
    XDG_CACHE_HOME XDG_DATA_HOME XDG_RUNTIME_DIR TMPDIR STEPFABRIC_BUILD_DIR STEPFABRIC_JOBS; do
    [ -n "${!name-}" ] && echo "$name=${!name}"
  done
  return 0
}

# On Ctrl-C or `kill` the program that enters the root would end at once and end the command with
# it, before that can write its report. So it ignores them, and the command gets them.
enter_and_pass_signals() {
  local enterer inner status passed
  (trap '' INT TERM HUP; exec "$@") <&0 &
  enterer=$!
  pass_signal() {
    passed=yes
    for inner in $(cat "/proc/$enterer/task/$enterer/children" 2>/dev/null || pgrep -P "$enterer"); do
      kill "-$1" "$inner" 2>/dev/null || true
    done
  }
  trap 'pass_signal INT' INT
  trap 'pass_signal TERM' TERM
  trap 'pass_signal HUP' HUP
  passed=yes
  while [ -n "$passed" ]; do
    passed=
    status=0
    wait "$enterer" || status=$?
  done
  exit "$status"
}
# Inside, the signals have their usual effect again.
hearing=(env --default-signal=INT,TERM,HUP)

enter_with_bubblewrap() {
  local root=$1 folder setting
  shift
  local arguments=(--bind "$root" / --dev-bind /dev /dev --proc /proc --tmpfs /run --die-with-parent)
  while read -r folder; do arguments+=(--bind "$folder" "$folder"); done < <(visible_host_folders)
  [ ! -d "$host_python/serial" ] || arguments+=(--ro-bind "$host_python" "$inner_host_python")
  [ ! -d "$host_cura/plugins" ] || arguments+=(--ro-bind "$host_cura" "$inner_host_cura")
  arguments+=(--chdir "$PWD" --clearenv)
  while read -r setting; do
    arguments+=(--setenv "${setting%%=*}" "${setting#*=}")
  done < <(inner_environment)
  enter_and_pass_signals bwrap "${arguments[@]}" -- "${hearing[@]}" "$@"
}

enter_with_proot() {
  local root=$1 folder setting
  shift
  local arguments=(-r "$root" -b /dev -b /proc -w "$PWD")
  [ ! -d "$host_python/serial" ] || arguments+=(-b "$host_python:$inner_host_python")
  [ ! -d "$host_cura/plugins" ] || arguments+=(-b "$host_cura:$inner_host_cura")
  local settings=()
  while read -r folder; do arguments+=(-b "$folder"); done < <(visible_host_folders)
  while read -r setting; do settings+=("$setting"); done < <(inner_environment)
  settings+=("PATH=$environment/proot_bin:/usr/sbin:/usr/bin:/sbin:/bin")
  enter_and_pass_signals env -i "${settings[@]}" "$(command -v proot)" "${arguments[@]}" \
    "${hearing[@]}" "$@"
}

if [ "${STEPFABRIC_TOOLS:-}" != root ] && native_tools_suffice; then
  exec "$@"
fi

root=$(tool_root_path)
[ -d "$root" ] || make_tool_root "$root" || exit 1

command -v bwrap >/dev/null || need_host_packages bubblewrap || true
if command -v bwrap >/dev/null && bwrap --bind "$root" / --dev-bind /dev /dev --proc /proc true 2>/dev/null; then
  enter_with_bubblewrap "$root" "$@"
fi
command -v proot >/dev/null || need_host_packages proot || true
if command -v proot >/dev/null && proot -r "$root" -b /dev -b /proc true 2>/dev/null; then
  say "this machine refuses bubblewrap's mounts; entering the tool root with proot (slower system calls)"
  enter_with_proot "$root" "$@"
fi
say "the tool root in $root cannot be entered here: both bubblewrap and proot were refused."
say "Use a Debian 13 machine or container and install the packages of tools/environment/packages.txt there."
exit 1
