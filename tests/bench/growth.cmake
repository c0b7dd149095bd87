# cmake -D VALGRIND=<valgrind> -D DIRECTORC=<directorc> -D LARGE=<large_project> -D OUT=<folder> -P growth.cmake
# Counts the instructions of `directorc check` on a project of 500 groups and on one of 5,000: ten times the work, give or take a fifth.
set(most 12)

file(REMOVE_RECURSE ${OUT})
foreach(groups 500 5000)
  file(MAKE_DIRECTORY ${OUT}/${groups})
  execute_process(COMMAND ${LARGE} ${groups} ${OUT}/${groups} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${VALGRIND} --tool=callgrind --callgrind-out-file=${OUT}/${groups}.out ${DIRECTORC} check ${OUT}/${groups}/main.yaml
                  OUTPUT_VARIABLE printed ERROR_VARIABLE errors RESULT_VARIABLE status)
  if(NOT status STREQUAL 0)
    message(FATAL_ERROR "directorc check of ${groups} groups ends with ${status}\n${printed}\n${errors}")
  endif()
  file(STRINGS ${OUT}/${groups}.out totals REGEX "^(totals|summary): ")
  list(GET totals 0 line)
  string(REGEX MATCH "[0-9]+" instructions_${groups} "${line}")
endforeach()
math(EXPR tenths "10 * ${instructions_5000} / ${instructions_500}")
math(EXPR ratio "${tenths} / 10")
math(EXPR rest "${tenths} % 10")
message("500 groups: ${instructions_500} instructions, 5,000 groups: ${instructions_5000}: ${ratio}.${rest} times as many")
if(NOT ratio LESS most)
  message(FATAL_ERROR "Something in the compiler takes more than its share of a large behaviour.")
endif()
