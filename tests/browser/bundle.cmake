# SPDX-License-Identifier: MIT
# cmake -D NODE=<program> -D NPM=<program> -D ROOT=<the project> -D WORK=<folder> -P bundle.cmake
# Bundles the script and the style sheet of the pages again and compares them with compiler/page/bundle. With DIRECTOR_BLESS=1 in the environment the
# files there are rewritten.
include(${CMAKE_CURRENT_LIST_DIR}/../support/npm_packages.cmake)
set(from ${ROOT}/compiler/page/web)
begin(${from} bundle)
file(GLOB sources ${from}/*.ts ${from}/*.css ${from}/*.mjs ${from}/tsconfig.json)
file(COPY ${sources} DESTINATION ${into})
execute_process(COMMAND ${NODE} bundle.mjs out WORKING_DIRECTORY ${into} COMMAND_ERROR_IS_FATAL ANY)
foreach(file page.js page.css)
  if("$ENV{DIRECTOR_BLESS}" STREQUAL "1")
    file(COPY_FILE ${into}/out/${file} ${ROOT}/compiler/page/bundle/${file} ONLY_IF_DIFFERENT)
  endif()
  file(SHA256 ${into}/out/${file} made)
  file(SHA256 ${ROOT}/compiler/page/bundle/${file} kept)
  if(NOT made STREQUAL kept)
    message(SEND_ERROR "compiler/page/bundle/${file} is not what compiler/page/web becomes: `npm ci && npm run bundle` there writes it")
  endif()
endforeach()
