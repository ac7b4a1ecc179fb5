# SPDX-License-Identifier: Apache-2.0
# The compiler for the chip: RV32IMC without operating system, picolibc for what C++ needs.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_ASM_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
if(PROCESSOR_HAS_ZBB)
  set(bit_manipulation _zbb)
endif()
# With its path: ccache looks for a name alone in the working directory, and then caches nothing.
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=picolibc.specs
  OUTPUT_VARIABLE picolibc_specs OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(processor_flags "-march=rv32imc_zicsr${bit_manipulation} -mabi=ilp32 --specs=${picolibc_specs}")
# By force, so that a build folder from before a change of these takes them over.
set(CMAKE_CXX_FLAGS ${processor_flags} CACHE STRING "" FORCE)
set(CMAKE_ASM_FLAGS ${processor_flags} CACHE STRING "" FORCE)
