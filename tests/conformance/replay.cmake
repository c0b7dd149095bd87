# SPDX-License-Identifier: MIT
# cmake -D DIRECTORC=<program> -D SCENARIO=<file> -D TRACE=<file to write> -P replay.cmake
# Records a trace of the scenario. `directorc replay` must find the same events when it plays the trace again, and `directorc trace` must
# print the same lines as `directorc simulate`, except for inputs.
execute_process(COMMAND ${DIRECTORC} simulate --decisions --times --trace ${TRACE} ${SCENARIO} OUTPUT_VARIABLE simulated ERROR_QUIET)
execute_process(COMMAND ${DIRECTORC} replay ${TRACE} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT status EQUAL 0 OR NOT said MATCHES "events, all the same")
  message(FATAL_ERROR "${said}")
endif()
execute_process(COMMAND ${DIRECTORC} trace ${TRACE} OUTPUT_VARIABLE traced COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[^\n]*\\] > [^\n]*\n" "" simulated "${simulated}")
string(REGEX REPLACE "[^\n]*\\] > [^\n]*\n" "" traced "${traced}")
if(NOT simulated STREQUAL traced)
  message(FATAL_ERROR "simulated:\n${simulated}\ntraced:\n${traced}")
endif()
