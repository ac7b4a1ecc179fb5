# SPDX-License-Identifier: Apache-2.0
add_subdirectory(${CMAKE_SOURCE_DIR}/tests/motion_reference ${CMAKE_BINARY_DIR}/tests/motion_reference)
add_verilated_model(step_generator_model TOP step_generator)

add_unit_test(step_generator_reference_test
  SOURCES step_generator_reference_test.cpp
  LIBRARIES verilated_bus motion_reference step_generator_model
  LABELS unit drivers)

# The same with more runs than an everyday check has time for.
add_test(NAME step_generator_reference_slow_test COMMAND step_generator_reference_test)
set_tests_properties(step_generator_reference_slow_test PROPERTIES
  LABELS slow TIMEOUT 1800 ENVIRONMENT STEP_GENERATOR_RUNS=500)
