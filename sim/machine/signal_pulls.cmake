# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, the pull of each signal as elements of a C++ array, out of the table SIGNALS:
# cmake -DOUTPUT=signal_pulls.inc -DSIGNALS=constraints/signals.csv -P signal_pulls.cmake
file(READ ${SIGNALS} rows)
# A semicolon would begin another element of the list.
string(REPLACE ";" "," rows "${rows}")
string(STRIP "${rows}" rows)
string(REPLACE "\n" ";" rows "${rows}")
list(POP_FRONT rows header)
if(NOT header MATCHES "^port,direction,pull,")
  message(FATAL_ERROR "${SIGNALS}: port, direction and pull are wanted as first columns")
endif()
set(elements "")
foreach(row IN LISTS rows)
  if(NOT row MATCHES "^([a-z0-9_]+),(in|out),(none|up|down),")
    message(FATAL_ERROR "${SIGNALS}: ${row}")
  endif()
  string(APPEND elements "SignalPull{\"${CMAKE_MATCH_1}\", Pull::${CMAKE_MATCH_3}},\n")
endforeach()
file(WRITE ${OUTPUT} "${elements}")
