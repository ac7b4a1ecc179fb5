# Makes the Debian 13 tool root that holds every tool of the project, once per user and package list.
# Sourced by enter.sh. Progress goes to standard error. SPDX-License-Identifier: Apache-2.0

readonly suite=trixie

tool_root_path() {
  local key
  key=$(cat "$environment/packages.txt" "$environment/tool_root.sh" | sha256sum | cut -c1-12)
  echo "${STEPFABRIC_TOOL_ROOTS:-${XDG_CACHE_HOME:-$HOME/.cache}/stepfabric}/tool-root-$key"
}

package_list() {
  sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$environment/packages.txt"
}

# The Debian mirror that this machine's own apt is configured for.
debian_mirror() {
  local uri
  while read -r uri; do
    case $uri in
      *debian-security*|*ubuntu-security*) continue ;;
      */debian|*/debian/) echo "$uri"; return 0 ;;
    esac
  done < <(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 2>/dev/null | sort -u)
  say "apt on this machine names no Debian mirror (a source whose address ends in /debian)."
  say "Set STEPFABRIC_DEBIAN_MIRROR to one, or install the packages of tools/environment/packages.txt" \
    "on a Debian 13 machine or container."
  return 1
}

# This machine's settings for reaching the mirror: proxies, certificates, retries, date checks.
host_apt_options() {
  apt-config dump 2>/dev/null |
    grep -E '^Acquire::(http|https|Check-|Retries|ForceIPv|AllowInsecure|AllowWeak|AllowDowngrade)' || true
}

# Makes the root next to its place and renames it when whole, so an interrupted set-up leaves nothing
# behind that a later call could take for a tool root.
make_tool_root() {
  local root=$1 partial keyring mirror started
  started=$SECONDS
  mkdir -p "$(dirname "$root")"
  exec 9>"$(dirname "$root")/lock"
  if ! flock -n 9; then
    say "another call is making the tool root; waiting for it"
    flock 9
  fi
  if [ -d "$root" ]; then exec 9>&-; return 0; fi

  command -v mmdebstrap >/dev/null || need_host_packages mmdebstrap || return 1
  keyring=/usr/share/keyrings/debian-archive-keyring.gpg
  [ -f "$keyring" ] || need_host_packages debian-archive-keyring || return 1
  mirror=${STEPFABRIC_DEBIAN_MIRROR:-$(debian_mirror)} || return 1

  say "making the Debian 13 tool root, once: about 3 to 6 minutes, 3.5 GB in $root"
  partial="$root.partial"
  rm -rf --one-file-system "$partial" || return 1
  host_apt_options > "$root.aptoptions"
  if ! mmdebstrap --variant=apt --keyring="$keyring" --aptopt="$root.aptoptions" \
    --dpkgopt='path-exclude=/usr/share/doc/*' \
    --dpkgopt='path-exclude=/usr/share/man/*' \
    --dpkgopt='path-exclude=/usr/share/locale/*' \
    --dpkgopt='path-exclude=/usr/share/info/*' \
    --dpkgopt='path-exclude=/usr/lib/picolibc/*/lib/*rv64*' \
    --dpkgopt='path-exclude=/usr/lib/picolibc/*/lib/*rv32e*' \
    --dpkgopt='path-exclude=/usr/lib/picolibc/*/lib/*rv32*f*' \
    --dpkgopt='path-exclude=/usr/lib/gcc/riscv64-unknown-elf/*/rv64*' \
    --include="$(package_list | paste -sd,)" \
    "$suite" "$partial" "deb $mirror $suite main" > "$root.log" 2>&1; then
    tail -n 20 "$root.log" >&2
    say "the tool root could not be made; the whole log is in $root.log. The next call tries again."
    return 1
  fi
  rm -rf "$partial"/var/cache/apt/archives/*.deb "$partial"/var/lib/apt/lists/*
  mv "$partial" "$root"
  rm -f "$root.aptoptions"
  exec 9>&-
  say "tool root made in $((SECONDS - started)) s"
}
