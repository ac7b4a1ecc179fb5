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

find_program(OBJCOPY_TOOL riscv64-unknown-elf-objcopy REQUIRED)

# <name>_code: the loader at the end of a chip's memory, whose size the option says; <source> includes it.
function(add_boot_loader name source chip_memory)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name})
  add_executable(${name}.elf $<TARGET_OBJECTS:boot_loader_parts> ${firmware}/platform/memory.cpp
    ${firmware}/platform/memory_calls.cpp)
  target_include_directories(${name}.elf PRIVATE ${firmware})
  target_compile_features(${name}.elf PRIVATE cxx_std_23)
  set_target_properties(${name}.elf PROPERTIES LINKER_LANGUAGE CXX
    LINK_DEPENDS "${boot_loader}/boot_loader.ld;${ARGN}")
  target_compile_options(${name}.elf PRIVATE ${code_options})
  target_link_options(${name}.elf PRIVATE ${code_options} ${memory_map} ${chip_memory} -nostartfiles
    -T ${boot_loader}/boot_loader.ld -Wl,--gc-sections -Wl,--no-relax-gp -Wl,--no-warn-rwx-segments -Wl,-Map=${name}.map)
  add_custom_command(OUTPUT ${folder}/loader_image.bin
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${OBJCOPY_TOOL} -O binary ${name}.elf ${folder}/loader_image.bin
    COMMAND ${SIZE_TOOL} -A ${name}.elf
    DEPENDS ${name}.elf VERBATIM)
  add_code(${name}_code ${source})
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${folder}/loader_image.bin)
  target_include_directories(${name}_code PRIVATE ${folder})
endfunction()

add_boot_loader(boot_loader ${boot_loader}/reset.S "${chip_memory}")
# Of the machine of `print --machine`, whose chip may have more memory. A source of its own, since it depends on another file.
configure_file(${boot_loader}/reset.S ${CMAKE_CURRENT_BINARY_DIR}/other_machine_reset.S COPYONLY)
add_boot_loader(other_machine_boot_loader ${CMAKE_CURRENT_BINARY_DIR}/other_machine_reset.S
  "${other_machine_memory}" ${other_machine_memory_file})
