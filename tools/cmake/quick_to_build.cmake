# SPDX-License-Identifier: Apache-2.0
# quick_to_build(): the programs of the current folder and those below are compiled with -O1. For those whose run
# time is spent waiting, or in libraries: it saves a sixth of the compiler's time, with long headers (JSON, Asio) a quarter.
function(quick_to_build)
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-O1>)
endfunction()
