# SPDX-License-Identifier: MIT
# cmake -D NODE=<program> -D NPM=<program> -D CHROMIUM=<program> -D DIRECTORC=<program> -D SOCCER=<program> -D FROM=<this folder> -D ROOT=<the project> -D WORK=<folder> -P hour.cmake
# Records an hour of soccer, writes it as one page and tests the page in a browser (hour.mjs).
include(${CMAKE_CURRENT_LIST_DIR}/../support/npm_packages.cmake)
begin(${FROM} hour)
file(COPY ${FROM}/hour.mjs ${FROM}/situations.mjs DESTINATION ${into})
execute_process(COMMAND ${SOCCER} --seconds 3600 --trace ${into}/hour.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${DIRECTORC} trace ${into}/hour.jsonl --to=html --behaviour behaviours/soccer/soccer.yaml -o ${into}/out/hour.html
                WORKING_DIRECTORY ${ROOT} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE ${into}/hour.jsonl) # 241 MB
execute_process(COMMAND ${NODE} hour.mjs ${CHROMIUM} ${into}/out WORKING_DIRECTORY ${into} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the page of an hour is not as it should be; a picture of it is in ${into}/out")
endif()
