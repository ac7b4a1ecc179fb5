# SPDX-License-Identifier: Apache-2.0
# Registers and memories that two Verilated models of the chip both have, a line for each:
#   REGISTER(its variable in the first model, its variable in the second)
# Usage: awk -v only_in_first=REGEX -v only_in_second=REGEX -f match_registers.awk FIRST___024root.h SECOND___024root.h
# Fails where a register is in one model alone and its name does not match that model's REGEX (checked for all
# registers), or where two of one name are not of one type.
#
# A register whose signal has a name has this name in both. One without, n12_q, has a number that counts all nets of a
# netlist: within one instance they come in the order of the source, so that the n-th of one is the n-th of the other.

# Registers end in _q; memories are arrays. Everything else is computed from them.
/printer_core__DOT__[A-Za-z0-9_]*;$/ && !/__Vtrigprevexpr|__Vdly|__Vcell/ {
  variable = $NF
  sub(/;$/, "", variable)
  type = $0
  sub(/^ */, "", type)
  sub(/ *[A-Za-z0-9_]*;$/, "", type)
  if (type !~ /^(CData|SData|IData|QData|VlWide<[0-9]+>)\/\*[0-9]+:0\*\/$/ && type !~ /^VlUnpacked</)
    fail("unknown type `" type "' of " variable)
  if (variable !~ /_q$/ && type !~ /^VlUnpacked/) next
  model = FILENAME == ARGV[1] ? 1 : 2
  if (match(variable, /__DOT__n[0-9]+_q$/)) {
    instance = substr(variable, 1, RSTART - 1)
    number = substr(variable, RSTART + 8) + 0
    unnamed[model, instance, ++unnamed_count[model, instance]] = number
    type_of[model, instance, number] = type
    instances[instance]
  } else {
    add(model, variable, variable, type)
  }
}

END {
  if (failed) exit 1
  for (instance in instances) for (model = 1; model <= 2; ++model) name_in_order(model, instance)
  for (key in variable_of) {
    split(key, part, SUBSEP)
    other = 3 - part[1]
    if ((other, part[2]) in variable_of) {
      if (types[key] != types[other, part[2]])
        fail(part[2] " is " types[key] " in one model, " types[other, part[2]] " in the other")
      if (part[1] == 1) lines[++count] = "REGISTER(" variable_of[1, part[2]] ", " variable_of[2, part[2]] ")"
    } else if (variable_of[key] !~ (part[1] == 1 ? only_in_first : only_in_second)) {
      fail(variable_of[key] " is in one model only")
    }
  }
  if (count == 0) fail("no registers at all")
  if (failed) exit 1
  sort(lines, count)
  for (i = 1; i <= count; ++i) print lines[i]
}

function fail(message) {
  print "match_registers: " message > "/dev/stderr"
  failed = 1
}

function add(model, name, variable, type) {
  variable_of[model, name] = variable
  types[model, name] = type
}

function name_in_order(model, instance,    i, count, numbers) {
  count = unnamed_count[model, instance]
  for (i = 1; i <= count; ++i) numbers[i] = unnamed[model, instance, i]
  sort(numbers, count)
  for (i = 1; i <= count; ++i)
    add(model, instance " " i, instance "__DOT__n" numbers[i] "_q", type_of[model, instance, numbers[i]])
}

# Insertion: a thousand lines at most.
function sort(values, count,    i, j, value) {
  for (i = 2; i <= count; ++i) {
    value = values[i]
    for (j = i - 1; j >= 1 && values[j] > value; --j) values[j + 1] = values[j]
    values[j + 1] = value
  }
}
