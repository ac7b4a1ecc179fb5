#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fails where a C++ file is not as clang-format writes it. Usage: check_format.sh PROJECT
set -euo pipefail
cd "$1"
find firmware sim tests tools -path firmware/registers -prune -o \( -name '*.cpp' -o -name '*.hpp' \) -print0 |
  xargs -0 clang-format --dry-run --Werror
