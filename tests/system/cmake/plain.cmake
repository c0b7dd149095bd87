# SPDX-License-Identifier: MIT
# cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<a folder beside this script> -D COMPILER=<compiler> -D FLAGS=<its flags> -P plain.cmake
# Configures Director without a preset, so that CMake's default for Release, -O3, is used. Warnings are no errors, because other compilers may have
# other ones. With DIRECTOR_WERROR=ON those sources compile for which GCC 12 has wrong warnings about strings at -O3.
file(REMOVE_RECURSE ${WORK})
cmake_path(SET sources NORMALIZE ${SOURCE}/../../../..)
function(configure)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${sources} -B ${WORK} -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${COMPILER}
                          -D CMAKE_CXX_FLAGS=${FLAGS} -D DIRECTOR_TESTS=OFF -D DIRECTOR_BEHAVIOURS=OFF -D DIRECTOR_CLANG=OFF ${ARGN}
                  OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "the project is not configured:\n${said}")
  endif()
endfunction()

configure()
execute_process(COMMAND ninja -C ${WORK} -t commands all OUTPUT_VARIABLE commands)
if(NOT commands MATCHES "-O3 " OR commands MATCHES "-Werror[ \n]")
  message(FATAL_ERROR "not compiled at -O3, or with warnings as errors:\n${commands}")
endif()

configure(-D DIRECTOR_WERROR=ON)
set(folder runtime/CMakeFiles/director_hosted.dir/hosted/trace)
execute_process(COMMAND ninja -C ${WORK} ${folder}/json_lines.cpp.o ${folder}/perfetto.cpp.o
                OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "what compiles at -O2 does not at -O3:\n${said}")
endif()
