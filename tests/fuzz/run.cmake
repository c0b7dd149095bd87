# SPDX-License-Identifier: MIT
# cmake -D PROGRAM=<fuzzer> -D TARGET=<name> -D FROM=<tests/fuzz> -D CORPUS=<folder> -D WORK=<folder> -D SECONDS=<n> -P run.cmake
# Runs a fuzzer for SECONDS, beginning with the corpus. Fails if it finds a fault, or if it reaches over 2 % fewer edges than golden/edges.txt says.
# With DIRECTOR_BLESS=1 in the environment that number is updated.
cmake_policy(SET CMP0057 NEW)
set(tolerance 2)
set(golden ${FROM}/golden/edges.txt)

# New inputs go to WORK and not to the corpus. The seed is always the same, so that each run tries similar inputs: a fault that it reports is likely a
# new one.
file(GLOB known_inputs ${CORPUS}/*)
if(NOT known_inputs)
  message(FATAL_ERROR "${CORPUS} is empty: cmake --build TREE --target fuzz_corpus unpacks it.")
endif()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/corpus)
set(ENV{ASAN_OPTIONS} "detect_leaks=1:allocator_may_return_null=1")
execute_process(
  COMMAND ${PROGRAM} -seed=1 -max_total_time=${SECONDS} -max_len=16384 -timeout=20 -rss_limit_mb=1500 -malloc_limit_mb=700 -dict=${FROM}/words.dict
          -print_final_stats=1 -verbosity=1 -artifact_prefix=${WORK}/ ${WORK}/corpus ${CORPUS}
  OUTPUT_QUIET ERROR_VARIABLE log RESULT_VARIABLE status)
file(WRITE ${WORK}/log.txt "${log}")

string(REGEX MATCH "\\(([0-9]+) inline 8-bit counters\\)" _ "${log}")
set(all "${CMAKE_MATCH_1}")
string(REGEX MATCH "INITED +cov: ([0-9]+)" _ "${log}")
set(known "${CMAKE_MATCH_1}")
string(REGEX MATCH "DONE +cov: ([0-9]+)" _ "${log}")
set(edges "${CMAKE_MATCH_1}")
string(REGEX MATCH "stat::number_of_executed_units: +([0-9]+)" _ "${log}")
set(inputs "${CMAKE_MATCH_1}")
if(NOT status STREQUAL 0 OR NOT edges)
  string(LENGTH "${log}" size)
  if(size GREATER 6000)
    math(EXPR from "${size} - 6000")
    string(SUBSTRING "${log}" ${from} -1 log)
  endif()
  message(FATAL_ERROR "${log}\nfuzz_${TARGET} ends with ${status}. What did it is in ${WORK}; give the file to ${PROGRAM} to see it again.")
endif()
math(EXPR percent "100 * ${edges} / ${all}")
message("${TARGET}: ${edges} of ${all} edges (${percent} %), ${known} of them by the corpus alone; ${inputs} inputs in ${SECONDS} s")

set(was 0)
set(others "")
if(EXISTS ${golden})
  file(STRINGS ${golden} lines REGEX "^[^#]")
  foreach(line IN LISTS lines)
    if(line MATCHES "^${TARGET} ([0-9]+)$")
      set(was ${CMAKE_MATCH_1})
    else()
      list(APPEND others "${line}")
    endif()
  endforeach()
endif()
math(EXPR least "${was} - ${was} * ${tolerance} / 100")
if("$ENV{DIRECTOR_BLESS}" STREQUAL 1)
  # The golden has the number of edges that the corpus alone reaches, because that number does not depend on the speed of the machine.
  if(known GREATER was OR edges LESS least)
    list(APPEND others "${TARGET} ${known}")
    list(SORT others)
    list(JOIN others "\n" text)
    file(WRITE ${golden} "# Edges of the libraries that the corpus of each fuzzer runs: fewer fail the test. Changed by ./bless fuzz only.\n${text}\n")
  endif()
elseif(was EQUAL 0)
  message(FATAL_ERROR "${golden} does not have ${TARGET}; ./bless fuzz writes it.")
elseif(edges LESS least)
  message(FATAL_ERROR "Before, ${was} edges ran: add to the corpus (tests/fuzz/grow) what reaches them, or, if that is meant, ./bless fuzz.")
endif()
