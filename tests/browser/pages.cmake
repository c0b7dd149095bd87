# SPDX-License-Identifier: MIT
# cmake -D NODE=<program> -D NPM=<program> -D CHROMIUM=<program> -D DIRECTORC=<program> -D FROM=<this folder> -D ROOT=<the project> -D WORK=<folder> -P pages.cmake
include(${CMAKE_CURRENT_LIST_DIR}/install.cmake)
begin(${FROM} pages)
file(GLOB scripts ${FROM}/*.mjs)
file(COPY ${scripts} DESTINATION ${into})
execute_process(COMMAND ${DIRECTORC} docs behaviours/soccer/soccer.yaml behaviours/robocup/robocup.yaml tests/docs/explore/photo.yaml -o ${into}/out
                        "--link=https://git.example.org/{file}#L{line}"
                WORKING_DIRECTORY ${ROOT} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NODE} pages.mjs ${CHROMIUM} ${into}/out WORKING_DIRECTORY ${into} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "a page is not as it should be; pictures of them are in ${into}/out")
endif()
