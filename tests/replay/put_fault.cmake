# SPDX-License-Identifier: Apache-2.0
# Copies a source with one text, which it must have exactly once, replaced by another:
#   cmake -DINPUT=FILE -DOUTPUT=FILE -DFIND=TEXT -DREPLACE=TEXT -P put_fault.cmake
file(READ ${INPUT} source)
string(FIND "${source}" "${FIND}" first)
string(FIND "${source}" "${FIND}" last REVERSE)
if(first EQUAL -1 OR NOT first EQUAL last)
  message(FATAL_ERROR "${INPUT} has not exactly one place for this fault: ${FIND}")
endif()
string(REPLACE "${FIND}" "${REPLACE}" source "${source}")
file(WRITE ${OUTPUT} "${source}")
