# SPDX-License-Identifier: Apache-2.0
add_subdirectory(${CMAKE_SOURCE_DIR}/tests/motion_reference ${CMAKE_BINARY_DIR}/tests/motion_reference)
add_verilated_model(step_generator_model TOP step_generator)

add_unit_test(step_generator_test
  SOURCES step_generator_test.cpp step_generator_control_test.cpp step_generator_extruder_test.cpp
    step_generator_override_test.cpp step_generator_ramp_test.cpp step_generator_rate_test.cpp step_generator_refusal_test.cpp
    step_generator_settings_test.cpp step_generator_stop_test.cpp
    ${CMAKE_SOURCE_DIR}/firmware/drivers/step_generator.cpp
  LIBRARIES verilated_bus step_generator_model
  LABELS unit driver ARGUMENTS --gtest_filter=-*whole*)

# A ramp of a hundred million clocks.
keep_result(kept step_generator_slow_test)
add_test(NAME step_generator_slow_test
  COMMAND ${kept} -- $<TARGET_FILE:step_generator_test> --gtest_filter=*whole*)
set_tests_properties(step_generator_slow_test PROPERTIES LABELS slow TIMEOUT 1800)

add_unit_test(step_generator_reference_test
  SOURCES step_generator_reference_test.cpp
  LIBRARIES verilated_bus motion_reference step_generator_model
  LABELS unit driver)

add_unit_test(step_generator_wild_test
  SOURCES step_generator_wild_test.cpp wild_program.cpp wild_actions.cpp
  LIBRARIES verilated_bus step_generator_model
  LABELS unit driver)

# The same with more runs than an everyday check has time for.
foreach(name reference wild)
  keep_result(kept step_generator_${name}_slow_test)
  add_test(NAME step_generator_${name}_slow_test
    COMMAND ${kept} -- ${CMAKE_COMMAND} -E env STEP_GENERATOR_RUNS=250 $<TARGET_FILE:step_generator_${name}_test>)
  set_tests_properties(step_generator_${name}_slow_test PROPERTIES LABELS slow TIMEOUT 1800)
endforeach()

# The VHDL in GHDL against the netlist in Verilator.
add_executable(step_generator_edges step_generator_edges.cpp)
target_link_libraries(step_generator_edges
  PRIVATE strict_warnings verilated_bus motion_reference step_generator_model)
keep_result(kept step_generator_cross_check)
add_test(NAME step_generator_cross_check
  COMMAND ${kept} ${bench_contents} ${CMAKE_SOURCE_DIR}/tools/hardware -- ${CMAKE_CURRENT_SOURCE_DIR}/step_generator_cross_check.sh $<TARGET_FILE:step_generator_edges>
    ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/step_generator_cross_check 0 1 2 3)
set_tests_properties(step_generator_cross_check PROPERTIES LABELS "driver;testbench" TIMEOUT 600)

# Tables for the pictures of rtl/motion/pictures.
add_executable(step_generator_traces step_generator_traces.cpp
  ${CMAKE_SOURCE_DIR}/firmware/drivers/step_generator.cpp)
target_link_libraries(step_generator_traces PRIVATE strict_warnings verilated_bus step_generator_model)
