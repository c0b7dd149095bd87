# SPDX-License-Identifier: MIT
# cmake -D DIRECTORC=<program> -D SCENARIO=<file> -P refused.cmake
# The behaviour of the scenario has an error that keeps it from running: exit status 1, a finding, and no event.
foreach(command simulate test)
  execute_process(COMMAND ${DIRECTORC} ${command} ${SCENARIO} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT status EQUAL 1)
    message(FATAL_ERROR "directorc ${command} ${SCENARIO}: exit status ${status}, not 1\n${out}${err}")
  endif()
  if(NOT "${out}${err}" MATCHES "error: [^\n]*\\[[a-z_]+\\]")
    message(FATAL_ERROR "directorc ${command} ${SCENARIO}: no finding of level error\n${out}${err}")
  endif()
  if("${out}" MATCHES "(^|\n)(run|start|>) ")
    message(FATAL_ERROR "directorc ${command} ${SCENARIO}: it ran\n${out}")
  endif()
endforeach()
