# SPDX-License-Identifier: Apache-2.0
# gdb: what it must know of the chip. Before `target`.
# A gdb for many machines takes a program that names no system for one of Linux, and would step by breakpoints at
# where it believes that the next instruction lies: the chip steps by itself, over wfi and into traps, too.
set osabi none
# There are triggers for instructions, none for data: gdb watches data by steps.
set can-use-hw-watchpoints 0
# The simulation may be slower than real time.
set remotetimeout 60
# Behind `monitor reset halt` the registers are others than gdb has read.
define hookpost-monitor
  maintenance flush register-cache
end
