# SPDX-License-Identifier: MIT
# cmake -D NODE=<program> -D NPM=<program> -D CHROMIUM=<program> -D LIVE=<program> -D SOCCER=<program> -D FROM=<this folder> -D WORK=<folder> -P live.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../support/npm_packages.cmake)
begin(${FROM} live)
file(COPY ${FROM}/live.mjs ${FROM}/situations.mjs DESTINATION ${into})
execute_process(COMMAND ${NODE} live.mjs ${CHROMIUM} ${LIVE} ${SOCCER} ${into}/out WORKING_DIRECTORY ${into} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "a live page is not as it should be; pictures of the situations that failed are in ${into}/out")
endif()
