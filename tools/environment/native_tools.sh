# Checks whether this machine's own tools suffice, so that no tool root is needed.
# Sourced by enter.sh. SPDX-License-Identifier: Apache-2.0

# at_least COMMAND MINIMUM: the first version number that `COMMAND --version` prints is not lower.
at_least() {
  local found
  command -v "$1" >/dev/null || return 1
  found=$("$1" --version 2>/dev/null | grep -oE '[0-9]+(\.[0-9]+)+' | head -n 1)
  [ -n "$found" ] && [ "$(printf '%s\n%s\n' "$2" "$found" | sort -V | head -n 1)" = "$2" ]
}

# GHDL before 5 writes wrong Verilog, mostly silently; the other floors are what the project is tested with.
native_tools_suffice() {
  at_least ghdl 5.0 && at_least verilator 5.032 && at_least cmake 3.25 && at_least ninja 1.10 &&
    at_least g++ 14.0 && at_least riscv64-unknown-elf-g++ 14.0 && at_least yosys 0.52 &&
    at_least gnuplot 5.4 && command -v ccache >/dev/null && command -v z3 >/dev/null && command -v curl >/dev/null &&
    [ -x /usr/lib/postgresql/17/bin/postgres ] &&
    command -v mosquitto_sub >/dev/null && command -v systemd-analyze >/dev/null && command -v udevadm >/dev/null &&
    python3 -c 'import websockets.sync.client' 2>/dev/null &&
    command -v chromium >/dev/null && command -v chromedriver >/dev/null &&
    at_least clang-format 19.0 && native_fuzzer_links && native_libraries_compile
}

native_fuzzer_links() {
  clang++-19 -fsanitize=fuzzer,address,undefined -x c++ - -o /dev/null 2>/dev/null <<< '#include <cstddef>
extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, std::size_t) { return 0; }'
}

native_libraries_compile() {
  g++ -std=c++20 -fsyntax-only -x c++ - 2>/dev/null <<'CPP' || return 1
#include <CLI/CLI.hpp>
#include <boost/beast/version.hpp>
#include <elfutils/libdw.h>
#include <fmt/format.h>
#include <gelf.h>
#include <gtest/gtest.h>
#include <gmock/gmock.h>
#include <httplib.h>
#include <mosquitto.h>
#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>
#include <png.h>
#include <pqxx/pqxx>
#include <sqlite3.h>
#include <toml++/toml.hpp>
#include <zlib.h>
#include <glpk.h>
#if !__has_include(<highs/Highs.h>)
#error
#endif
CPP
  riscv64-unknown-elf-g++ -march=rv32im_zicsr -mabi=ilp32 --specs=picolibc.specs -std=c++23 -fsyntax-only \
    -x c++ - 2>/dev/null <<< '#include <array>
#include <expected>'
}
