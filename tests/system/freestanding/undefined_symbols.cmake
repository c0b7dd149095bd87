# SPDX-License-Identifier: MIT
# cmake -D NM=<nm> -D LINKER=<ld> -D OBJECTS=<list of object files> -D OUT=<file> -P undefined_symbols.cmake
# Links the object files to one, which resolves their references to each other, and fails if a symbol is still undefined, apart from four functions
# mem*.
file(STRINGS ${OBJECTS} objects)
execute_process(COMMAND ${LINKER} -r -o ${OUT} ${objects} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NM} --undefined-only --demangle ${OUT} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[ \t]+[Uwv] (memcpy|memmove|memset|memcmp)\n" "" strangers "${symbols}")
string(STRIP "${strangers}" strangers)
if(strangers)
  message(FATAL_ERROR "runtime/core needs more than the language gives:\n${strangers}")
endif()
list(LENGTH objects count)
message(STATUS "${count} object files have no undefined symbols but mem*")
