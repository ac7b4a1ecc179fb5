# SPDX-License-Identifier: Apache-2.0
# quick_to_build(): the programs of the current folder and those below are compiled with -O1. For those with long headers
# (JSON, Asio, command lines) whose run time is spent waiting: it saves a quarter of the compiler's time.
function(quick_to_build)
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-O1>)
endfunction()
