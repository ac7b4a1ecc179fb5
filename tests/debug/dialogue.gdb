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
break counted
continue
expect $pc &counted 2
expect $a0 1 3
delete
stepi
expect *(int*)&counter 1 4
hbreak loop
continue
expect $pc &loop 5
delete
set $a0 = 1000
stepi
expect $a0 1001 6
set *(int*)&counter = 7
expect *(int*)&counter 7 7
printf "PASSED\n"
disconnect
quit 0
