# SPDX-License-Identifier: Apache-2.0
# The same with gdb, in C's words. `target` has been connected, and the program is loaded by gdb.
define expect
  if $arg0 != $arg1
    printf "FAILED: line %d\n", $arg2
    kill
    quit 1
  end
end

monitor reset halt
load
expect $pc 0x80000000 1
# Behind a reset gdb knows the registers, and steps from there.
stepi
stepi
monitor reset halt
expect $pc 0x80000000 2
stepi
expect $pc 0x80000002 3
monitor reset halt
break counted
continue
expect $pc &counted 4
expect $a0 1 5
delete
stepi
expect *(int*)&counter 1 6
hbreak loop
continue
expect $pc &loop 7
delete
set $a0 = 1000
stepi
expect $a0 1001 8
set *(int*)&counter = 7
expect *(int*)&counter 7 9
# Data is watched, though the chip has no trigger for it.
watch *(int*)&counter
continue
expect *(int*)&counter 1001 10
# Where nothing is, nothing is read.
set $refused = 0
python
try:
  gdb.parse_and_eval("*(int*)0x40000000").fetch_lazy()
except gdb.MemoryError:
  gdb.set_convenience_variable("refused", 1)
end
expect $refused 1 11
printf "PASSED\n"
disconnect
quit 0
