# SPDX-License-Identifier: Apache-2.0
# Runs make_project.tcl and the .sdc of a Quartus project with stand-ins for Quartus' commands, each of which checks its
# arguments against the board's tables, and says what is wrong or left out, a line for each.
# For Yosys' Tcl, with argv set: DIRECTORY BOARD_FOLDER
lassign $argv directory board_folder
set board [file tail $board_folder]
set complaints {}

proc complain {text} { lappend ::complaints $text }

# The rows of a table as dictionaries, by the names in its first line.
proc read_table {file} {
  set channel [open $file]
  set lines [split [string trim [read $channel]] \n]
  close $channel
  set names [split [lindex $lines 0] ,]
  set rows {}
  foreach line [lrange $lines 1 end] {
    set row {}
    foreach name $names cell [split $line ,] { dict set row $name $cell }
    lappend rows $row
  }
  return $rows
}

foreach row [read_table $board_folder/device.csv] {
  set device([dict get $row property]) [dict get $row value]
}
foreach row [read_table $board_folder/banks.csv] {
  set volts([dict get $row bank]) [dict get $row volts]
}
foreach row [read_table $board_folder/pins.csv] {
  set bank_of(PIN_[dict get $row pin]) [dict get $row bank]
}

# The top module's ports with their indices, and `input` or `output`, as its Verilog has them.
proc read_ports {file top} {
  set channel [open $file]
  set text [read $channel]
  close $channel
  if {![regexp "\\nmodule $top\\s+\\((\[^;\]*)\\);" \n$text -> header]} {
    complain "there is no module $top"
    return
  }
  foreach {- direction - high name} [regexp -all -inline {(input|output)\s+(\[(\d+):0\])?\s*(\w+)} $header] {
    if {$high eq ""} { set ::port($name) $direction; continue }
    for {set index 0} {$index <= $high} {incr index} { set ::port($name\[$index\]) $direction }
  }
}
read_ports $directory/$board.v $board

# Options with a value, those without, and what remains, into the caller's `given` and `rest`.
proc take {command with_value without arguments} {
  upvar given given rest rest
  array unset given
  array set given {}
  set rest {}
  while {[llength $arguments] > 0} {
    set arguments [lassign $arguments word]
    if {$word in $with_value} {
      if {[llength $arguments] == 0} { complain "$command: $word without a value" }
      set arguments [lassign $arguments given($word)]
    } elseif {$word in $without} {
      set given($word) yes
    } elseif {[string match -* $word]} {
      complain "$command: no option $word"
    } else {
      lappend rest $word
    }
  }
}

proc in_project {command} { if {$::state ne "open"} { complain "$command: no project is open" } }

# Quartus' commands for a project.
set state none
rename package tcl_package
proc package {args} {
  if {$args eq "require ::quartus::project"} { set ::state loaded; return }
  tcl_package {*}$args
}

proc project_new {args} {
  take project_new -revision -overwrite $args
  if {$::state ne "loaded"} { complain "project_new: ::quartus::project is not loaded, or a project is open" }
  if {$rest ne $::board} { complain "project_new: $rest is not $::board" }
  set ::state open
}

proc export_assignments {} { in_project export_assignments; set ::exported yes }
proc project_close {} {
  in_project project_close
  if {![info exists ::exported]} { complain "project_close: the assignments are not exported" }
  set ::state closed
}

proc set_global_assignment {args} {
  take set_global_assignment -name {} $args
  in_project set_global_assignment
  if {[llength $rest] != 1} { complain "set_global_assignment: one value is wanted: $args" }
  set name $given(-name)
  set value [lindex $rest 0]
  switch $name {
    FAMILY { set good [expr {$value eq $::device(family)}] }
    DEVICE { set good [expr {$value eq $::device(device)}] }
    TOP_LEVEL_ENTITY { set good [expr {$value eq $::board}] }
    PROJECT_OUTPUT_DIRECTORY { set good [regexp {^\w+$} $value] }
    VERILOG_FILE { set good [regexp {\.v$} $value] }
    MIF_FILE { set good [regexp {\.mif$} $value] }
    SDC_FILE { set good [regexp {\.sdc$} $value] }
    ALLOW_POWER_UP_DONT_CARE { set good [expr {$value eq "OFF"}] }
    RESERVE_ALL_UNUSED_PINS { set good [expr {$value eq "AS INPUT TRI-STATED WITH WEAK PULL-UP"}] }
    default { complain "set_global_assignment: no $name"; return }
  }
  if {!$good} { complain "set_global_assignment: $name is $value" }
  if {[string match *_FILE $name]} {
    if {![file exists $::directory/$value]} { complain "there is no $value" }
    if {[info exists ::listed($value)]} { complain "$value is listed twice" }
    set ::listed($value) yes
  } elseif {[info exists ::global($name)]} {
    complain "$name is said twice"
  } else {
    set ::global($name) $value
  }
}

# A parameter of all cells, or of those of an entity or instance. Its values are those of Quartus 7 to 13.
proc set_parameter {args} {
  take set_parameter {-name -to -entity} {} $args
  in_project set_parameter
  if {[llength $rest] != 1} { complain "set_parameter: one value is wanted: $args" }
  if {![info exists given(-name)] || $given(-name) ne "CYCLONEII_SAFE_WRITE"} {
    complain "set_parameter: no such name: $args"
    return
  }
  if {[info exists given(-to)] || [info exists given(-entity)]} {
    complain "set_parameter: $given(-name) is wanted for all cells"
  }
  set value [lindex $rest 0]
  if {$value ni {NO_CHANGE PORT_SWAP RESTRUCTURE VERIFIED_SAFE}} { complain "set_parameter: $given(-name) is $value" }
  if {[info exists ::parameter($given(-name))]} { complain "$given(-name) is said twice" }
  set ::parameter($given(-name)) $value
}

# Block RAM of a Cyclone II may write wrongly with two clocks, where port A writes. Quartus refuses such memory, until it
# is told that it has been verified to be safe: then port A must not write.
proc check_safe_write {} {
  set value [expr {[info exists ::parameter(CYCLONEII_SAFE_WRITE)] ? $::parameter(CYCLONEII_SAFE_WRITE) : ""}]
  if {$::device(family) ne "Cyclone II"} {
    if {$value ne ""} { complain "CYCLONEII_SAFE_WRITE is for a Cyclone II, not for a $::device(family)" }
    return
  }
  if {$value ne "VERIFIED_SAFE"} { complain "Quartus refuses the memory: CYCLONEII_SAFE_WRITE is not VERIFIED_SAFE" }
  set memories 0
  foreach file [glob -directory $::directory *.v] {
    set channel [open $file]
    set text [read $channel]
    close $channel
    set cells [regexp -all {\maltsyncram\s*#\(} $text]
    if {$cells > [regexp -all {\.wren_a\(1'b0\)} $text]} { complain "[file tail $file]: port A may write" }
    incr memories $cells
  }
  if {$memories == 0} { complain "there is no altsyncram" }
}

proc check_port {command name} {
  if {![info exists ::port($name)]} { complain "$command: there is no port $name" }
}

proc set_location_assignment {args} {
  take set_location_assignment -to {} $args
  in_project set_location_assignment
  set pin [lindex $rest 0]
  check_port set_location_assignment $given(-to)
  if {![info exists ::bank_of($pin)]} { complain "the board has no $pin"; return }
  if {[info exists ::user($pin)]} { complain "$given(-to) and $::user($pin) share $pin" }
  if {[info exists ::location($given(-to))]} { complain "$given(-to) has two pins" }
  set ::user($pin) $given(-to)
  set ::location($given(-to)) $pin
}

proc set_instance_assignment {args} {
  take set_instance_assignment {-name -to} {} $args
  in_project set_instance_assignment
  set values [dict create IO_STANDARD {"3.3-V LVTTL" "2.5 V"} WEAK_PULL_UP_RESISTOR ON \
    CURRENT_STRENGTH_NEW {4MA 8MA} FAST_OUTPUT_REGISTER ON]
  check_port set_instance_assignment $given(-to)
  if {![dict exists $values $given(-name)]} { complain "set_instance_assignment: no $given(-name)"; return }
  if {$rest eq "" || [lindex $rest 0] ni [dict get $values $given(-name)]} {
    complain "$given(-to): $given(-name) is $rest"
  }
  if {[info exists ::instance($given(-name),$given(-to))]} { complain "$given(-to): $given(-name) is said twice" }
  set ::instance($given(-name),$given(-to)) [lindex $rest 0]
}

# Each port has one pin, whose bank has the voltage that the port is given, and each file is in the project.
proc check_project {} {
  if {$::state ne "closed"} { complain "the project is left open" }
  foreach name {FAMILY DEVICE TOP_LEVEL_ENTITY ALLOW_POWER_UP_DONT_CARE RESERVE_ALL_UNUSED_PINS} {
    if {![info exists ::global($name)]} { complain "$name is not said" }
  }
  check_safe_write
  foreach file [glob -tails -directory $::directory *.v *.mif *.sdc] {
    if {![info exists ::listed($file)]} { complain "$file is not in the project" }
  }
  foreach name [lsort [array names ::port]] {
    if {![info exists ::location($name)]} { complain "$name has no pin"; continue }
    if {![info exists ::instance(IO_STANDARD,$name)]} { complain "$name has no I/O standard"; continue }
    set bank $::bank_of($::location($name))
    set wanted [string range $::instance(IO_STANDARD,$name) 0 2]
    if {$bank eq ""} { complain "the bank of $name is not known"; continue }
    if {$::volts($bank) != $wanted} { complain "$name wants $wanted V in bank $bank of $::volts($bank) V" }
  }
}

# Those for timing constraints.
proc get_ports {name} { check_port get_ports $name; return [list port $name] }
proc get_clocks {name} {
  if {![info exists ::clock($name)]} { complain "get_clocks: there is no clock $name" }
  return [list clock $name]
}
proc all_registers {} { return registers }
proc derive_pll_clocks {} { set ::derived(pll) yes }
proc derive_clock_uncertainty {} { set ::derived(uncertainty) yes }

proc constrain {collection how} {
  lassign $collection kind name
  if {$kind ne "port"} return
  if {[info exists ::constrained($name)]} { complain "$name has two timing constraints" }
  set ::constrained($name) $how
}

# What the boards' oscillators make, at most. The 28 MHz of the DE2-70 are eight times the colour carrier of NTSC by its
# sample designs; its manual has not been compared, so a percent more is wanted.
set oscillator_mhz [dict create clock_50mhz 50 clock_25mhz 25 clock_28mhz 28.86]

proc create_clock {args} {
  take create_clock {-name -period} {} $args
  if {![string is double -strict $given(-period)] || $given(-period) <= 0} { complain "create_clock: period $given(-period)" }
  set ::clock($given(-name)) $given(-period)
  set port [lindex $rest 0 1]
  constrain [lindex $rest 0] clock
  if {$::port($port) ne "input"} { complain "create_clock: $port is an output" }
  if {![dict exists $::oscillator_mhz $port]} { complain "create_clock: $port is no clock input"; return }
  # Not longer, and not much shorter by rounding.
  set period [expr {1000.0 / [dict get $::oscillator_mhz $port]}]
  if {$given(-period) > $period || $given(-period) < 0.99 * $period} {
    complain "create_clock: $port has a period of $given(-period) ns"
  }
}

proc set_clock_groups {args} {
  take set_clock_groups -group -asynchronous $args
  if {![info exists given(-asynchronous)] || [lindex $given(-group) 0] ne "clock"} { complain "set_clock_groups: $args" }
  set ::apart([lindex $given(-group) 1]) yes
}

proc set_max_delay {args} {
  take set_max_delay {-from -to} {} $args
  if {![string is double -strict [lindex $rest 0]] || $rest <= 0 || $rest > 20} { complain "set_max_delay: $rest ns" }
  foreach {end direction} {-from input -to output} {
    lassign $given($end) kind name
    if {$kind eq "port" && $::port($name) ne $direction} { complain "set_max_delay $end $name, which is no $direction" }
    constrain $given($end) delay
  }
}

proc check_timing {} {
  foreach name {pll uncertainty} { if {![info exists ::derived($name)]} { complain "derive_$name... is left out" } }
  foreach name [lsort [array names ::port]] {
    if {![info exists ::constrained($name)]} {
      complain "$name has no timing constraint"
    } elseif {[dict exists $::oscillator_mhz $name] && $::constrained($name) ne "clock"} {
      complain "$name is a clock without a period"
    }
  }
  # Oscillators of their own have no relation to each other: all but one are in a group.
  set together [lmap name [lsort [array names ::clock]] {
    if {[info exists ::apart($name)]} continue
    set name
  }]
  if {[llength $together] > 1} { complain "$together are taken as clocks of one oscillator" }
}

cd $directory
if {[catch {
  source make_project.tcl
  check_project
  source $board.sdc
  check_timing
} message]} { complain "Tcl: $message" }
foreach complaint $complaints { puts "complaint: $complaint" }
puts "checked [array size port] ports, [array size listed] files, [array size clock] clocks"
