# SPDX-License-Identifier: Apache-2.0
# All registers and memories of a Verilated model's design, a line for each: VARIABLE(name).
# Usage: awk -f list_variables.awk V....___024root.h
/ printer_core__DOT__[A-Za-z0-9_]*;$/ && (/_q;$/ || /VlUnpacked/) {
  sub(/;$/, "", $NF)
  print "VARIABLE(" $NF ")"
}
