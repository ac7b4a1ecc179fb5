# SPDX-License-Identifier: Apache-2.0
# The warnings under which all C++ of the project is compiled; warnings are errors.
add_library(strict_warnings INTERFACE)
target_compile_options(strict_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wundef
  -Wnon-virtual-dtor -Woverloaded-virtual -Werror)
