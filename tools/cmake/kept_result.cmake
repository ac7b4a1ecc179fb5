# SPDX-License-Identifier: Apache-2.0
# keep_result(VARIABLE NAME): in VARIABLE, what stands before the command of the test NAME, which is the same whenever it
# runs; paths that it reads and `--` stand between. The result is kept until one of these, a file in the command line or
# the list of tools has other contents.
function(keep_result variable name)
  set(${variable} ${CMAKE_SOURCE_DIR}/tools/cmake/kept_result.sh ${CMAKE_BINARY_DIR}/kept_results/${name}
    ${CMAKE_SOURCE_DIR}/tools/environment/packages.txt PARENT_SCOPE)
endfunction()
