# SPDX-License-Identifier: MIT
# run(<command>...): runs the command in the folder WORK, and sets `said` to its output and errors. If it fails, so does the test, which prints them.
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}:\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()
