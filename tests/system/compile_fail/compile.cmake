# SPDX-License-Identifier: MIT
# cmake -D COMPILER=<compiler> -D FLAGS=<its flags> -D PRECOMPILED=<header> -D FOLDERS=<where headers are> -D CASE=<source> -P compile.cmake
# Compiles the case without and with MISTAKE defined, and compares the message with its line `// Message:`.
file(STRINGS ${CASE} line REGEX "^// Message: ")
string(REGEX REPLACE "^// Message: " "" message "${line}")
if(NOT message)
  message(FATAL_ERROR "${CASE} has no line // Message:")
endif()
# A case may have a line `// Flags:` with further flags, or define macros for the header. Then it cannot use the precompiled header.
file(STRINGS ${CASE} own REGEX "^// Flags: ")
string(REGEX REPLACE "^// Flags: " "" own "${own}")
separate_arguments(own)
list(APPEND FLAGS ${own})
file(STRINGS ${CASE} defines REGEX "^#define ")
if(NOT defines AND NOT own)
  list(APPEND FLAGS -include ${PRECOMPILED})
endif()
list(TRANSFORM FOLDERS PREPEND -I)
set(compile ${CMAKE_COMMAND} -E env LC_ALL=C ${COMPILER} ${FLAGS} ${FOLDERS} ${CASE})

execute_process(COMMAND ${compile} -fsyntax-only RESULT_VARIABLE result ERROR_VARIABLE said)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "without the mistake it must compile:\n${said}")
endif()
execute_process(COMMAND ${compile} -fsyntax-only -D MISTAKE RESULT_VARIABLE result ERROR_VARIABLE said)
if(result EQUAL 0) # the compiler finds some mistakes only when it generates code
  execute_process(COMMAND ${compile} -c -o /dev/null -D MISTAKE RESULT_VARIABLE result ERROR_VARIABLE said)
endif()
if(result EQUAL 0)
  message(FATAL_ERROR "with the mistake it must not compile, and it does")
endif()
if(NOT said MATCHES "error: [^\n]*(${message})" AND NOT said MATCHES "note: [^\n]*(${message})")
  message(FATAL_ERROR "it does not compile, but says nothing that fits \"${message}\":\n${said}")
endif()
