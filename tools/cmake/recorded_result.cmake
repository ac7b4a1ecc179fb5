# SPDX-License-Identifier: Apache-2.0
# is_recorded(VARIABLE GROUP path...): whether the table tests/recorded.tsv says that the tests of GROUP have passed
# with what these files, and all files in these folders, hold now. Then they need not be built. With the option
# STEPFABRIC_RUN_RECORDED nothing counts as recorded. The digest depends on no machine: names below the project and contents.
option(STEPFABRIC_RUN_RECORDED "Tests run whose result is recorded, too" OFF)
set(recorded_table ${CMAKE_SOURCE_DIR}/tests/recorded.tsv)

function(is_recorded variable group)
  set(files)
  foreach(path IN LISTS ARGN)
    if(IS_DIRECTORY ${CMAKE_SOURCE_DIR}/${path})
      file(GLOB_RECURSE found RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS LIST_DIRECTORIES false ${CMAKE_SOURCE_DIR}/${path}/*)
      # Pages, tables of results, pictures; what no recorded test runs or reads, placement among it.
      list(FILTER found EXCLUDE REGEX "\\.(md|tsv|svg)$|^boards/interface/|^tools/(figures|wiring)/|^tools/hardware/place_")
      list(APPEND files ${found})
    elseif(EXISTS ${CMAKE_SOURCE_DIR}/${path})
      list(APPEND files ${path})
    else()
      message(FATAL_ERROR "recorded result of ${group}: there is no ${path}")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES files)
  list(SORT files)
  set(contents)
  foreach(file IN LISTS files)
    file(SHA256 ${CMAKE_SOURCE_DIR}/${file} hash)
    string(APPEND contents "${file} ${hash}\n")
  endforeach()
  string(SHA256 digest "${contents}")
  list(TRANSFORM files PREPEND ${CMAKE_SOURCE_DIR}/)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files} ${recorded_table})
  set_property(GLOBAL APPEND PROPERTY recorded_groups ${group})
  set_property(GLOBAL PROPERTY recorded_digest_of_${group} ${digest})
  set(${variable} OFF PARENT_SCOPE)
  if(STEPFABRIC_RUN_RECORDED OR STEPFABRIC_ZBB OR NOT EXISTS ${recorded_table})
    return()
  endif()
  file(STRINGS ${recorded_table} row REGEX "^${group}\t${digest}$")
  if(row)
    set(${variable} ON PARENT_SCOPE)
    add_test(NAME ${group}_is_recorded COMMAND ${CMAKE_COMMAND} -E echo
      "passed before with the same sources: without its row in tests/recorded.tsv it runs again")
    set_tests_properties(${group}_is_recorded PROPERTIES LABELS slow)
  endif()
endfunction()

# add_recorded_test(NAME...): tests of a group whose names do not begin with the group's.
function(add_recorded_test)
  set_property(GLOBAL APPEND PROPERTY recorded_tests ${ARGN})
endfunction()

# add_record_target(NAME): where the tests of all groups (<group>_... and those added) pass, with what was built for them,
# writes the table.
function(add_record_target name)
  get_property(groups GLOBAL PROPERTY recorded_groups)
  set(rows "# Written by the target ${name}: tests that have passed, and the digest of their sources.\n")
  foreach(group IN LISTS groups)
    get_property(digest GLOBAL PROPERTY recorded_digest_of_${group})
    string(APPEND rows "${group}\t${digest}\n")
  endforeach()
  file(WRITE ${CMAKE_BINARY_DIR}/recorded.tsv.new "${rows}")
  list(JOIN groups "|" any)
  get_property(tests GLOBAL PROPERTY recorded_tests)
  list(JOIN tests "|" any_test)
  add_custom_target(${name}
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_BINARY_DIR}/recorded.tsv.new ${CMAKE_BINARY_DIR}/recorded.tsv.before
    COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${CMAKE_BINARY_DIR} --output-on-failure --no-tests=error -FA .* -R "^(${any})_|^(${any_test})$"
    COMMAND ${CMAKE_COMMAND} -E compare_files ${CMAKE_BINARY_DIR}/recorded.tsv.new ${CMAKE_BINARY_DIR}/recorded.tsv.before
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_BINARY_DIR}/recorded.tsv.new ${recorded_table}
    USES_TERMINAL VERBATIM)
endfunction()
