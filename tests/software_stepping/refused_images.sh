#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Usage: refused_images.sh FOLDER IMAGE...
# The linker refuses each of these images of the firmware's build folder, since it is too large for its memory.
set -eu

folder=$1
shift
status=0
for image in "$@"; do
  if output=$(cmake --build "$folder" --target "$image" 2>&1); then
    echo "$image: it was linked" >&2
    status=1
  elif ! echo "$output" | grep "the image is too large: too little memory left for the stack"; then
    echo "$image: refused without its reason:" >&2
    echo "$output" >&2
    status=1
  fi
done
exit $status
