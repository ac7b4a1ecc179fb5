# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, a C++ file that holds the style and the scripts of the page as texts:
# cmake -DOUTPUT=page_files.cpp -DSTYLE=style.css "-DSCRIPTS=a.js;b.js" -P embed.cmake
function(text_of files result)
  set(text "")
  foreach(file IN LISTS files)
    file(READ ${file} part)
    # Only the repository needs the licence line in each file; the page has its own.
    string(REGEX REPLACE "^[^\n]*SPDX[^\n]*\n" "" part "${part}")
    string(APPEND text "${part}")
  endforeach()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

text_of("${STYLE}" style)
text_of("${SCRIPTS}" script)
# A literal of 64 KB is the least that a compiler must take.
file(WRITE ${OUTPUT} "// Made by sim/report/page/embed.cmake.
#include \"sim/report/page_files.hpp\"

namespace report {

const char* const page_style = R\"page_file(${style})page_file\";
const char* const page_script = R\"page_file(${script})page_file\";

}  // namespace report
")
