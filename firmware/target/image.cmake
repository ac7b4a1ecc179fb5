# SPDX-License-Identifier: Apache-2.0
# The target `firmware` of the host's build: <build>/firmware/firmware.elf, with its sizes and a map; and
# `firmware_software_stepping`: software_stepping.elf in the same folder.
# It comes after all folders, because it takes the sources that they have registered.
include(ExternalProject)
get_property(sources GLOBAL PROPERTY firmware_sources)
list(JOIN sources "|" sources)
# The generator checks the entry; here it only selects what is linked.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${STEPFABRIC_MACHINE})
file(STRINGS ${STEPFABRIC_MACHINE} kinematics REGEX "^kinematics = \"[a-z_]+\"")
string(REGEX REPLACE "^kinematics = \"([a-z_]+)\".*" "\\1" kinematics "${kinematics}")
set(tools)
file(STRINGS ${STEPFABRIC_MACHINE} second_tool REGEX "^\\[tool_1\\]")
if(second_tool)
  set(tools _two_tools)
endif()

ExternalProject_Add(firmware_image
  SOURCE_DIR ${CMAKE_CURRENT_LIST_DIR}
  BINARY_DIR ${CMAKE_BINARY_DIR}/firmware
  PREFIX ${CMAKE_BINARY_DIR}/firmware_image
  LIST_SEPARATOR "|"
  CMAKE_ARGS
    -DCMAKE_TOOLCHAIN_FILE=${CMAKE_CURRENT_LIST_DIR}/toolchain.cmake
    -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
    -DFIRMWARE_SOURCES=${sources}
    -DKINEMATICS=${kinematics}
    -DTOOLS=${tools}
    -DPROCESSOR_HAS_ZBB=${chip_has_zbb}
    -DCHIP_MEMORY_BYTES=${chip_memory_bytes}
    -DCOMPARISON_MEMORY_BYTES=${comparison_memory_bytes}
    -DFAST_MEMORY_BYTES=${fast_memory_bytes}
    -DGENERATED_INCLUDES=${CMAKE_BINARY_DIR}/generated
  BUILD_ALWAYS ON
  BUILD_BYPRODUCTS ${CMAKE_BINARY_DIR}/firmware/firmware.elf
  BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --target firmware.elf
  INSTALL_COMMAND ""
  DEPENDS machine_header_file benchmark_machine_header machine_header_at_250000 machine_header_at_1000000
    machine_header_at_3000000)
add_custom_target(firmware DEPENDS firmware_image)

# Refuses a machine at whose clock (clock_mhz), or without it at any clock, the main loop misses a deadline, as far as that is
# proved of such a machine (tools/timing/machine_schedule.cpp).
option(STEPFABRIC_CHECK_SCHEDULE "The firmware's build refuses a machine whose deadlines cannot be met" ON)
if(STEPFABRIC_CHECK_SCHEDULE)
  set(zbb_flag $<$<STREQUAL:${chip_has_zbb},true>:--zbb>)
  add_dependencies(firmware check_schedule)
  add_custom_command(TARGET firmware POST_BUILD COMMAND check_schedule ${CMAKE_BINARY_DIR}/firmware/firmware.elf
    ${STEPFABRIC_MACHINE} ${zbb_flag} COMMAND_EXPAND_LISTS VERBATIM)
endif()

# Of the same objects, built only where they are requested; one at a time, since all are builds in the same
# folder.
set_property(GLOBAL APPEND PROPERTY JOB_POOLS firmware_folder=1)
add_custom_target(firmware_software_stepping
  COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR}/firmware --target software_stepping.elf
  DEPENDS firmware_image JOB_POOL firmware_folder VERBATIM)
foreach(kinematics IN ITEMS cartesian core_xy delta scara)
  foreach(image IN ITEMS hardware_${kinematics} hardware_${kinematics}_two_tools hardware_${kinematics}_fast
      hardware_${kinematics}_two_tools_fast software_${kinematics})
    add_custom_target(firmware_other_machine_${image}
      COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR}/firmware --target other_machine_${image}.elf
      DEPENDS firmware_image JOB_POOL firmware_folder VERBATIM)
  endforeach()
endforeach()
add_custom_target(stepping_benchmark_programs
  COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR}/firmware
    --target stepping_benchmark_hardware.elf stepping_benchmark_software.elf
      printing_benchmark_hardware.elf printing_benchmark_software.elf
  DEPENDS firmware_image JOB_POOL firmware_folder VERBATIM)
add_custom_target(filled_program
  COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR}/firmware --target filled_software.elf
  DEPENDS firmware_image JOB_POOL firmware_folder VERBATIM)
add_custom_target(processor_benchmark_programs
  COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR}/firmware
    --target processor_benchmarks processor_benchmarks_without_c processor_benchmarks_with_zbb
  DEPENDS firmware_image JOB_POOL firmware_folder VERBATIM)
add_custom_target(link_benchmark_programs
  COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR}/firmware
    --target link_benchmark_250000.elf link_benchmark_1000000.elf link_benchmark_3000000.elf
      link_benchmark_1000000_fast.elf link_benchmark_3000000_fast.elf
  DEPENDS firmware_image JOB_POOL firmware_folder VERBATIM)
