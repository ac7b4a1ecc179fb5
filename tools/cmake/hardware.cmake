# SPDX-License-Identifier: Apache-2.0
# add_testbench(NAME [SLOW] [WITHOUT_PROPERTIES] [BENCH entity] [GENERICS name=value...] [LABELS label...] [TIMEOUT seconds]): a
#   self-checking GHDL test bench, NAME.vhd of the current folder unless BENCH says otherwise, run against all of rtl/ and
#   boards/. SLOW is for benches of over five seconds: they are run only while tests/recorded.tsv does not hold.
# add_verilated_model(TARGET TOP entity [PREFIX name] [GENERICS name=value...] [TRACE] [FILES extra.vhd...]
#   [CONTROL file.vlt]): entity -> GHDL synthesis -> Verilog -> Verilator -> static library TARGET, with the
#   header <name>.h, which is V<entity>.h where no other is given.
file(GLOB_RECURSE rtl_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/rtl/*.vhd)
find_program(VERILATOR verilator REQUIRED)
find_program(GHDL ghdl REQUIRED)
execute_process(COMMAND ${VERILATOR} --getenv VERILATOR_ROOT
  OUTPUT_VARIABLE verilator_root OUTPUT_STRIP_TRAILING_WHITESPACE)

# What tools/hardware/run_testbench.sh reads.
set(bench_contents ${CMAKE_SOURCE_DIR}/rtl ${CMAKE_SOURCE_DIR}/boards ${CMAKE_SOURCE_DIR}/testbench
  ${CMAKE_SOURCE_DIR}/tools/hardware/weave_properties.sh)

function(add_testbench name)
  cmake_parse_arguments(PARSE_ARGV 1 argument "SLOW;WITHOUT_PROPERTIES" "TIMEOUT;BENCH" "GENERICS;LABELS")
  if(argument_SLOW AND slow_benches_recorded)
    return()
  endif()
  set(options)
  if(argument_WITHOUT_PROPERTIES)
    set(options --without-properties)
  endif()
  if(NOT argument_TIMEOUT)
    set(argument_TIMEOUT 300)
  endif()
  if(NOT argument_BENCH)
    set(argument_BENCH ${name})
  endif()
  list(TRANSFORM argument_GENERICS PREPEND -g)
  file(GLOB_RECURSE bench_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/testbench/*.vhd)
  keep_result(kept ${name})
  add_test(NAME ${name} COMMAND ${kept} ${bench_contents} -- ${CMAKE_SOURCE_DIR}/tools/hardware/run_testbench.sh ${options}
    ${CMAKE_BINARY_DIR}/testbench/${name} ${argument_BENCH} ${CMAKE_SOURCE_DIR} ${argument_GENERICS})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${argument_TIMEOUT}
    LABELS "testbench;${argument_LABELS}" SKIP_RETURN_CODE 77)
  if(argument_SLOW)
    add_recorded_test(${name})
  endif()
endfunction()

function(add_verilated_model target)
  cmake_parse_arguments(PARSE_ARGV 1 argument "TRACE" "TOP;PREFIX;CONTROL" "GENERICS;FILES;VERILATOR_ARGUMENTS")
  set(directory ${CMAKE_BINARY_DIR}/models/${target})
  set(library ${directory}/lib${target}.a)
  set(prefix V${argument_TOP})
  if(argument_PREFIX)
    set(prefix ${argument_PREFIX})
  endif()
  set(arguments ${argument_VERILATOR_ARGUMENTS})
  if(argument_TRACE)
    list(APPEND arguments --trace-fst)
  endif()
  set(control)
  if(argument_CONTROL)
    get_filename_component(control ${argument_CONTROL} ABSOLUTE)
    list(APPEND arguments ${control})
  endif()
  list(TRANSFORM argument_GENERICS PREPEND -g)
  set(extra)
  foreach(file IN LISTS argument_FILES)
    get_filename_component(file ${file} ABSOLUTE)
    list(APPEND extra ${file})
  endforeach()
  # The headers are named as outputs, so that files which include them are recompiled in the same
  # build: with a stale header a program would read the model's variables at wrong offsets.
  add_custom_command(OUTPUT ${library}
    BYPRODUCTS ${directory}/verilated/${prefix}.h
      ${directory}/verilated/${prefix}___024root.h
    COMMAND ${CMAKE_SOURCE_DIR}/tools/hardware/build_model.sh ${directory} ${target} ${argument_TOP} ${prefix}
      ${rtl_files} ${extra} -- ${argument_GENERICS} -- ${arguments}
    DEPENDS ${rtl_files} ${extra} ${control} ${CMAKE_SOURCE_DIR}/tools/hardware/build_model.sh
      ${CMAKE_SOURCE_DIR}/tools/hardware/name_registers.awk
    COMMENT "Verilating ${argument_TOP}" VERBATIM)
  add_custom_target(${target}_build DEPENDS ${library})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_build)
  target_include_directories(${target} SYSTEM INTERFACE ${directory}/verilated
    ${verilator_root}/include ${verilator_root}/include/vltstd)
  target_link_libraries(${target} INTERFACE ${library} pthread)
  if(argument_TRACE)
    target_link_libraries(${target} INTERFACE z)
  endif()
endfunction()
