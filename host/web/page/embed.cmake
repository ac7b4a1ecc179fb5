# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, a C++ file that holds the page as texts:
# cmake -DOUTPUT=page_files.cpp -DFOLDER=page "-DSCRIPTS=a.js;b.js" -P embed.cmake
file(READ ${FOLDER}/index.html html)
file(READ ${FOLDER}/page.css style)
file(READ ${FOLDER}/../openapi.json openapi)
set(script "")
foreach(file IN LISTS SCRIPTS)
  file(READ ${FOLDER}/${file} part)
  string(APPEND script "${part}")
endforeach()
file(WRITE ${OUTPUT} "// Made by host/web/page/embed.cmake.
#include \"host/web/page_files.hpp\"

namespace web {

const std::string_view page_html = R\"page_file(${html})page_file\";
const std::string_view page_style = R\"page_file(${style})page_file\";
const std::string_view page_script = R\"page_file(${script})page_file\";
const std::string_view openapi = R\"page_file(${openapi})page_file\";

}  // namespace web
")
