# SPDX-License-Identifier: MIT
# cmake -D NM=<nm> -D OBJECTS=<list of object files> -P nothing_reported.cmake
# Each function that reports to an observer must be empty: no more than a return.
file(STRINGS ${OBJECTS} objects)
execute_process(COMMAND ${NM} --print-size --demangle --radix=d ${objects} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[0-9]+ [0-9]+ [TtWw] director::Engine::report_[^\n]*" reports "${symbols}")
list(LENGTH reports count)
if(count LESS 5)
  message(FATAL_ERROR "only ${count} functions that report were found")
endif()
foreach(report IN LISTS reports)
  string(REGEX MATCH "^[0-9]+ 0*([0-9]+) . (.*)$" found "${report}")
  if(CMAKE_MATCH_1 GREATER 16)
    message(FATAL_ERROR "${CMAKE_MATCH_2} is not compiled out: ${CMAKE_MATCH_1} bytes")
  endif()
endforeach()
