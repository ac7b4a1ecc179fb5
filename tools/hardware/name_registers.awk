# SPDX-License-Identifier: Apache-2.0
# In the Verilog that GHDL writes, gives each register the name of the signal that it holds: n14233_q, which
# `phase` is assigned from, becomes phase_q. Usage: awk -f name_registers.awk netlist.v netlist.v
NR == FNR {
  if (match($0, /[A-Za-z][A-Za-z0-9_]* = n[0-9]+_q; \/(\/ \(isignal\)|\/ \(signal\)|\/\(module output\))/)) {
    split(substr($0, RSTART, RLENGTH), word, /[ ;]+/)
    if (!(word[3] in named)) named[word[3]] = word[1] "_q"
  }
  next
}
{
  rest = $0
  line = ""
  while (match(rest, /n[0-9]+_q/)) {
    token = substr(rest, RSTART, RLENGTH)
    line = line substr(rest, 1, RSTART - 1) (token in named ? named[token] : token)
    rest = substr(rest, RSTART + RLENGTH)
  }
  print line rest
}
