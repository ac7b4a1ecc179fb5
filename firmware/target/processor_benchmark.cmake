# SPDX-License-Identifier: Apache-2.0
# The programs of `bench processor`: each work an image of its own, with and without compressed
# instructions; and the firmware without its boot loader, for its size only.
set(benchmark ${firmware}/benchmark)
set(core_work linked_list.cpp matrix.cpp number_scanner.cpp core_work.cpp)
set(record_work record_work.cpp)
set(parser_work parser_work.cpp)
set(planner_work planner_work.cpp)
# The works of common benchmarks as those are compiled; the firmware's as the firmware is.
set(core_options -O3 -mno-save-restore)
set(record_options -O3 -mno-save-restore)
set(parser_options)
set(planner_options)

# The images of all works as <work>_benchmark<suffix>.elf, compiled and linked with these options too.
function(add_processor_benchmarks suffix)
  add_code(benchmark_frame_code${suffix} ${benchmark}/processor_program.cpp)
  set(built benchmark_frame_code${suffix})
  foreach(work core record parser planner)
    set(code ${work}_work_code${suffix})
    list(TRANSFORM ${work}_work PREPEND ${benchmark}/ OUTPUT_VARIABLE sources)
    add_code(${code} ${benchmark}/${work}_program.cpp ${sources})
    target_compile_options(${code} PRIVATE ${${work}_options})
    add_image(${work}_benchmark${suffix} ${code} benchmark_frame_code${suffix}
      firmware_code${suffix})
    # The processor's model has 64 KiB.
    target_link_options(${work}_benchmark${suffix}.elf PRIVATE -Wl,--defsym=memory_bytes=0x10000)
    list(APPEND built ${code})
    list(APPEND linked ${work}_benchmark${suffix}.elf)
  endforeach()
  if(suffix)
    add_code(firmware_code${suffix} ${firmware_code_sources})
    add_code(main_code${suffix} ${firmware}/main.cpp)
    add_code(hardware_stepping_code${suffix} ${hardware_stepping})
    list(APPEND built firmware_code${suffix} main_code${suffix} hardware_stepping_code${suffix})
  endif()
  add_image(firmware_alone${suffix} main_code${suffix} firmware_code${suffix}
    hardware_stepping_code${suffix})
  # It need not fit the chip's memory: it is not run.
  target_link_options(firmware_alone${suffix}.elf PRIVATE -Wl,--defsym=memory_bytes=0x20000)
  list(APPEND linked firmware_alone${suffix}.elf)
  foreach(target IN LISTS built linked)
    target_compile_options(${target} PRIVATE ${ARGN})
  endforeach()
  foreach(target IN LISTS linked)
    target_link_options(${target} PRIVATE ${ARGN})
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  endforeach()
  add_custom_target(processor_benchmarks${suffix} DEPENDS ${linked})
endfunction()

add_processor_benchmarks("")
add_processor_benchmarks(_without_c -march=rv32im_zicsr)
add_processor_benchmarks(_with_zbb -march=rv32imc_zicsr_zbb)
