# Installs packages on this machine. Sourced by enter.sh; messages go to standard error.
# SPDX-License-Identifier: Apache-2.0

# Runs apt-get; what it says is left in apt_output. While another apt process holds a lock, as the upgrades of a
# freshly started machine do, it is called again every 5 s, for 15 minutes. apt's own DPkg::Lock::Timeout would wait
# for dpkg's locks only, not for those of the package lists and of the archive.
apt_get() {
  local tries
  for tries in {1..180}; do
    apt_output=$(LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get -qq "$@" 2>&1) && return 0
    [[ $apt_output == *"Could not get lock"* ]] || return 1
    [ "$tries" != 1 ] || say "another apt process is at work on this machine; waiting for it"
    sleep 5
  done
  return 1
}

# Installs packages as root; other users get the command to run.
need_host_packages() {
  if [ "$(id -u)" != 0 ]; then
    say "missing on this machine: $*. Install them once with: sudo apt-get install $*"
    return 1
  fi
  command -v apt-get >/dev/null || { say "missing: $*, and there is no apt-get to install them"; return 1; }
  say "installing on this machine: $*"
  apt_get install -y --no-install-recommends "$@" && return 0
  apt_get update || printf '%s\n' "$apt_output" >&2
  apt_get install -y --no-install-recommends "$@" && return 0
  printf '%s\n' "$apt_output" >&2
  return 1
}
