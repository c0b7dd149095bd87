# SPDX-License-Identifier: MIT
# cmake -D SIZE=<size> -D PROCESSOR=<name> -D CORE=<objects> -D GENERATED=<objects> -D LINKED=<program of one task>;<of soccer> -D OUT=<file>
#   -P sizes.cmake
# Writes sizes in bytes to OUT, for ./bench and limits.cmake: the code of the engine, the generated code and tables of soccer, its Behaviour object,
# and the linked programs of one task and of soccer.
function(total column variable)
  execute_process(COMMAND ${SIZE} --totals ${ARGN} OUTPUT_VARIABLE table COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "([0-9]+)[ \t]+([0-9]+)[ \t]+([0-9]+)[ \t]+[0-9]+[ \t]+[0-9a-f]+[ \t]+\\(TOTALS\\)" line "${table}")
  set(${variable} ${CMAKE_MATCH_${column}} PARENT_SCOPE)
endfunction()
total(1 core ${CORE})
total(1 generated ${GENERATED})
total(3 object ${GENERATED})
list(GET LINKED 0 lamp)
list(GET LINKED 1 soccer)
total(1 lamp ${lamp})
total(1 soccer ${soccer})
math(EXPR code "${core} + ${generated}")
message("soccer on a ${PROCESSOR}: ${code} bytes of code and tables (engine ${core}, generated ${generated}), ${object} bytes of RAM for the Behaviour; linked: one task ${lamp}, soccer ${soccer}")
file(WRITE ${OUT} "${PROCESSOR} ${core} ${generated} ${object} ${lamp} ${soccer}\n")
