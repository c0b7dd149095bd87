# SPDX-License-Identifier: MIT
# cmake -D NODE=<program> -D NPM=<program> -D FROM=<this folder> -D ROOT=<the project> -D WORK=<folder> -P answers.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../support/npm_packages.cmake)
set(web ${ROOT}/compiler/page/web)
begin(${web} answers)
file(GLOB sources ${web}/*.ts ${FROM}/answers.mjs)
file(COPY ${sources} DESTINATION ${into})
execute_process(COMMAND ${NODE} answers.mjs WORKING_DIRECTORY ${into} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the page shows an answer for a moment in which it was not true, or none where it was")
endif()
