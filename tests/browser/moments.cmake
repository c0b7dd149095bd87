# SPDX-License-Identifier: MIT
# cmake -D NODE=<program> -D NPM=<program> -D MOMENTS=<program> -D FROM=<this folder> -D ROOT=<the project> -D WORK=<folder> -P moments.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../support/npm_packages.cmake)
set(web ${ROOT}/compiler/page/web)
begin(${web} engine_moments)
file(GLOB sources ${web}/*.ts ${FROM}/moments.mjs)
file(COPY ${sources} DESTINATION ${into})
# The first 1000 random behaviours, and the numbers of later ones that showed a fault which none of the first 1000 shows.
execute_process(COMMAND ${NODE} moments.mjs ${MOMENTS} 1 1000 1253 1413 1837 2012 2302 2599 2833 3580 4889 5148 9696 10491 WORKING_DIRECTORY ${into} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the page shows some moments otherwise than the engine has them")
endif()
