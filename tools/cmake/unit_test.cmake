# SPDX-License-Identifier: Apache-2.0
# add_unit_test(NAME SOURCES file... LIBRARIES target... LABELS label... TIMEOUT seconds [KEPT] [READS path...]): one
# googletest program, registered with ctest as one test. KEPT: it does the same whenever it runs, and its result is kept
# until its program or one of the paths that it reads changes.
find_package(GTest REQUIRED)

function(add_unit_test name)
  cmake_parse_arguments(PARSE_ARGV 1 argument "KEPT" "TIMEOUT" "SOURCES;LIBRARIES;LABELS;ARGUMENTS;READS")
  add_executable(${name} ${argument_SOURCES})
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR} ${CMAKE_SOURCE_DIR}/firmware)
  target_link_libraries(${name} PRIVATE strict_warnings ${argument_LIBRARIES} GTest::gmock_main)
  if(NOT argument_TIMEOUT)
    set(argument_TIMEOUT 300)
  endif()
  if(NOT argument_LABELS)
    set(argument_LABELS unit)
  endif()
  set(kept)
  if(argument_KEPT)
    keep_result(kept ${name})
    list(APPEND kept ${argument_READS} --)
  endif()
  add_test(NAME ${name} COMMAND ${kept} $<TARGET_FILE:${name}> ${argument_ARGUMENTS} WORKING_DIRECTORY ${CMAKE_BINARY_DIR})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${argument_TIMEOUT} LABELS "${argument_LABELS}")
  if("slow" IN_LIST argument_LABELS)
    set_tests_properties(${name} PROPERTIES COST ${slow_test_cost})
  endif()
endfunction()
