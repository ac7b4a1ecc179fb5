#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A bench that stops without calling std.env.finish fails, although GHDL exits with 0; one that
# finishes passes. Usage: unfinished_bench_test.sh PROJECT FOLDER
set -euo pipefail
project=$1 folder=$2
small=$folder/project
rm -rf "$folder"
mkdir -p "$small/rtl" "$small/boards" "$small/testbench"

# write_bench NAME LAST_STATEMENT: a bench whose only process ends with this statement.
write_bench() {
  cat > "$small/testbench/$1.vhd" << END
entity $1 is
end;
architecture test of $1 is
  signal clk : bit := '0';
begin
  process
  begin
    wait for 1 ns;
    clk <= not clk after 1 ns;
    $2
  end process;
end;
END
}
write_bench finishing_tb 'wait for 5 ns; std.env.finish;'
write_bench waiting_tb 'wait;'

run() {
  "$project/tools/hardware/run_testbench.sh" --without-properties "$folder/$1" "$1" "$small" \
    > "$folder/$1.log" 2>&1
}

run finishing_tb || { echo "a bench that finishes fails:"; cat "$folder/finishing_tb.log"; exit 1; }
if run waiting_tb; then echo "a bench that never finishes passes"; exit 1; fi
grep -q '^waiting_tb does not finish$' "$folder/waiting_tb.log" ||
  { echo "a bench that never finishes is not reported:"; cat "$folder/waiting_tb.log"; exit 1; }
