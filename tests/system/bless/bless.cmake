# SPDX-License-Identifier: MIT
# cmake -D PROBE=<program> -D TREE=<folder> -P bless.cmake
function(expect what)
  if(NOT (${ARGN}))
    message(FATAL_ERROR "not so: ${what}")
  endif()
endfunction()
function(run_probe result output)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env DIRECTOR_BLESS=${ARGV2} ${PROBE} [golden]
                  RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  set(${result} ${code} PARENT_SCOPE)
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${TREE})
file(MAKE_DIRECTORY ${TREE}/folder)
file(WRITE ${TREE}/one.txt "first\nanother\n")
file(WRITE ${TREE}/folder/left_over.txt "old\n")

run_probe(code text 0)
expect("the probe fails" code GREATER 0)
foreach(message
    "one.txt differs at line 2" "golden: another" "actual: second" "./bless rewrites it, if the change is meant"
    "folder/a.txt is missing; ./bless writes it"
    "folder/left_over.txt is not written any more; ./bless removes it")
  string(FIND "${text}" "${message}" place)
  expect("it says: ${message}; it said: ${text}" place GREATER_EQUAL 0)
endforeach()

run_probe(code text 1)
expect("blessing succeeds: ${text}" code EQUAL 0)
file(READ ${TREE}/one.txt one)
expect("the golden is rewritten" one STREQUAL "first\nsecond\n")
file(READ ${TREE}/folder/deep/b.txt b)
expect("a missing golden is written" b STREQUAL "b\n")
if(EXISTS ${TREE}/folder/left_over.txt)
  message(FATAL_ERROR "what is left over stays")
endif()

run_probe(code text 0)
expect("the blessed goldens pass: ${text}" code EQUAL 0)
