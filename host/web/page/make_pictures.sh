#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes host/web/page.png and page_phone.png: prints a file on a simulated printer and takes screenshots of the page in the
# middle of it (page_pictures of tests/host/browser; pngquant makes them small).
# Usage: tools/environment/enter.sh host/web/page/make_pictures.sh BUILD_FOLDER
set -euo pipefail
web=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
build=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$build/bin/page_pictures" "$web/../../examples/washer.gcode" "$scratch"
for picture in page page_phone; do
  if command -v pngquant > /dev/null; then
    pngquant --force --strip --quality 60-95 --output "$web/$picture.png" 128 "$scratch/$picture.png"
  else
    cp "$scratch/$picture.png" "$web/$picture.png"
  fi
done
ls -l "$web"/*.png
