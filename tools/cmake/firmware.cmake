# SPDX-License-Identifier: Apache-2.0
# add_firmware_library(NAME SOURCES file... DEPENDS folder...): one folder of the firmware as the host
# library firmware_NAME (for tests and simulation). The same sources are remembered for the image that
# runs on the soft core. A folder of headers only gives no SOURCES.
set_property(GLOBAL PROPERTY firmware_sources "")

function(add_firmware_library name)
  cmake_parse_arguments(PARSE_ARGV 1 argument "" "" "SOURCES;DEPENDS")
  set(target firmware_${name})
  if(argument_SOURCES)
    add_library(${target} STATIC ${argument_SOURCES})
    target_include_directories(${target} PUBLIC ${CMAKE_SOURCE_DIR}/firmware)
    target_link_libraries(${target} PRIVATE strict_warnings)
    target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti)
    foreach(depend IN LISTS argument_DEPENDS)
      target_link_libraries(${target} PUBLIC firmware_${depend})
    endforeach()
    foreach(source IN LISTS argument_SOURCES)
      set_property(GLOBAL APPEND PROPERTY firmware_sources ${CMAKE_CURRENT_SOURCE_DIR}/${source})
    endforeach()
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE ${CMAKE_SOURCE_DIR}/firmware)
    foreach(depend IN LISTS argument_DEPENDS)
      target_link_libraries(${target} INTERFACE firmware_${depend})
    endforeach()
  endif()
endfunction()
