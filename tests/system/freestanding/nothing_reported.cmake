# SPDX-License-Identifier: MIT
# cmake -D NM=<nm> -D OBJECTS=<list of object files> -P nothing_reported.cmake
# No other object file may call the functions in reports.cpp, which report events to an observer, so that the linker leaves them out.
file(STRINGS ${OBJECTS} objects)
set(reporting 0)
foreach(object IN LISTS objects)
  execute_process(COMMAND ${NM} --demangle ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "director::Engine::report_[^\n]*" reports "${symbols}")
  list(LENGTH reports count)
  if(object MATCHES "/reports\\.cpp")
    set(reporting ${count})
  elseif(count GREATER 0)
    message(FATAL_ERROR "${object} calls ${reports}, though observers are compiled out: ask observed() first")
  endif()
endforeach()
if(reporting LESS 5)
  message(FATAL_ERROR "only ${reporting} functions that report were found in reports.cpp")
endif()
