#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Formats all C++ of the project by .clang-format and the brace rule (braces.awk); with --check it
# only lists files that differ, and fails. Usage: format.sh PROJECT [--check]
set -euo pipefail
project=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
. "$project/tools/environment/native_tools.sh"
at_least clang-format 19.0 || {
  echo "clang-format 19 or newer is needed: tools/environment/enter.sh $0 $*" >&2
  exit 2
}
formatted=$(mktemp -d)
trap 'rm -rf "$formatted"' EXIT
cd "$project"

files() {
  find firmware host sim tests tools -path firmware/registers -prune -o \( -name '*.cpp' -o -name '*.hpp' \) -print
}
files | tar -cf - -T - | tar -xf - -C "$formatted"
# Braces everywhere first, so that the rule starts from one form. The setting is here and not in
# .clang-format, so that editors do not use it.
{ cat .clang-format; echo 'InsertBraces: true'; } > "$formatted/.clang-format"
(cd "$formatted" && files | xargs clang-format -i)

status=0
while read -r file; do
  awk -v columns=100 -f "$here/braces.awk" "$formatted/$file" > "$formatted/one"
  cmp -s "$file" "$formatted/one" && continue
  if [ "${2-}" = --check ]; then
    diff -u --label "$file" --label "$file, formatted" "$file" "$formatted/one" || status=1
  else
    cat "$formatted/one" > "$file"
  fi
done < <(files)
[ $status = 0 ] || echo "write it so: cmake --build build --target format" >&2
exit $status
