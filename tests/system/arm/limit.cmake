# SPDX-License-Identifier: MIT
# cmake -D SIZE=<size> -D PROGRAM=<elf> -D MOST=<bytes> -P limit.cmake
# The code and constants of the program take at most MOST bytes.
execute_process(COMMAND ${SIZE} ${PROGRAM} OUTPUT_VARIABLE table COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "\n[ \t]*([0-9]+)" line "${table}")
set(bytes "${CMAKE_MATCH_1}")
message("${PROGRAM}: ${bytes} bytes")
if(bytes STREQUAL "" OR bytes GREATER MOST)
  message(FATAL_ERROR "${PROGRAM} takes ${bytes} bytes, and ${MOST} at most are expected (tests/system/arm/CMakeLists.txt)")
endif()
