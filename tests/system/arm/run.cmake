# SPDX-License-Identifier: MIT
# cmake -D QEMU=<qemu-system-arm> -D MACHINE=<machine> -D PROGRAM=<elf> -D EXPECTED=<trace of the host> -D TOO_LARGE=<scenario>,... -P run.cmake
# Runs the program and compares its output with the host's trace, byte by byte. Lines that begin with `#` are about the program itself. Some of them
# name the scenarios that do not fit into the board's memory, which must be those of TOO_LARGE.
execute_process(
  COMMAND ${QEMU} -M ${MACHINE} -display none -monitor none -serial none -chardev stdio,id=host,signal=off
          -semihosting-config enable=on,target=native,chardev=host -kernel ${PROGRAM}
  OUTPUT_VARIABLE said ERROR_VARIABLE errors RESULT_VARIABLE status TIMEOUT 60)
if(NOT status STREQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ends with ${status}\n${said}\n${errors}")
endif()
string(REGEX MATCHALL "# [^\n]*\n" facts "${said}")
string(REGEX REPLACE "# [^\n]*\n" "" trace "${said}")
string(JOIN "" facts ${facts})
message("${facts}")
file(READ ${EXPECTED} expected)
string(REGEX MATCHALL "# left out: [^\n]*" left_out "${said}")
list(TRANSFORM left_out REPLACE "# left out: " "")
string(REPLACE "," ";" too_large "${TOO_LARGE}")
if(NOT left_out STREQUAL too_large)
  message(FATAL_ERROR "Not played, because they do not fit: ${left_out}; expected of: ${too_large}")
endif()
foreach(scenario IN LISTS left_out)
  string(FIND "${expected}" "== ${scenario}\n" begin)
  string(SUBSTRING "${expected}" ${begin} -1 from)
  string(FIND "${from}" "\n== " length)
  string(SUBSTRING "${from}" 0 ${length} block)
  string(REPLACE "${block}\n" "" expected "${expected}")
endforeach()
if(NOT trace STREQUAL expected)
  cmake_path(REPLACE_EXTENSION EXPECTED LAST_ONLY .${MACHINE}.txt OUTPUT_VARIABLE actual)
  file(WRITE ${actual} "${trace}")
  message(FATAL_ERROR "The trace is another one than on the host: compare ${EXPECTED} with ${actual}")
endif()
string(REGEX MATCHALL "\n" lines "${expected}")
list(LENGTH lines count)
message("${count} lines as on the host")
