# SPDX-License-Identifier: Apache-2.0
# The boot loader: linked by itself to the end of the memory, and as boot_loader_code the bytes of it, which
# become a part of an image.
set(boot_loader ${firmware}/boot_loader)
add_code(boot_loader_parts ${boot_loader}/start.S ${boot_loader}/main.cpp ${boot_loader}/line.cpp
  ${boot_loader}/frame_receiver.cpp ${boot_loader}/session.cpp ${firmware}/drivers/timer.cpp
  ${firmware}/platform/bus.cpp ${firmware}/platform/sleep.cpp)
# It does not set the global pointer, and has none of the memory functions that the compiler
# may call.
target_compile_options(boot_loader_parts PRIVATE -msmall-data-limit=0 -fno-tree-loop-distribute-patterns)

add_executable(boot_loader.elf $<TARGET_OBJECTS:boot_loader_parts> ${firmware}/platform/memory.cpp
  ${firmware}/platform/memory_calls.cpp)
target_include_directories(boot_loader.elf PRIVATE ${firmware})
target_compile_features(boot_loader.elf PRIVATE cxx_std_23)
set_target_properties(boot_loader.elf PROPERTIES LINKER_LANGUAGE CXX
  LINK_DEPENDS ${boot_loader}/boot_loader.ld)
target_compile_options(boot_loader.elf PRIVATE ${code_options})
target_link_options(boot_loader.elf PRIVATE ${code_options} ${memory_map} -nostartfiles
  -T ${boot_loader}/boot_loader.ld -Wl,--gc-sections -Wl,--no-relax-gp -Wl,--no-warn-rwx-segments -Wl,-Map=boot_loader.map)
find_program(OBJCOPY_TOOL riscv64-unknown-elf-objcopy REQUIRED)
add_custom_command(OUTPUT boot_loader.bin
  COMMAND ${OBJCOPY_TOOL} -O binary boot_loader.elf boot_loader.bin
  COMMAND ${SIZE_TOOL} -A boot_loader.elf
  DEPENDS boot_loader.elf VERBATIM)

add_code(boot_loader_code ${boot_loader}/reset.S)
set_source_files_properties(${boot_loader}/reset.S PROPERTIES
  OBJECT_DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/boot_loader.bin)
target_include_directories(boot_loader_code PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
