# SPDX-License-Identifier: MIT
# cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<the project> -D COMPILER=<compiler> -D FLAGS=<its flags> -P fetched.cmake
# Configures a project that adds Director by FetchContent. Building it would compile all of Director again, and the other projects here test the
# commands of director_add_behaviour, so this test only looks at the commands that ninja would run.
file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/ ${SOURCE}/../consumer/main.cpp ${SOURCE}/../consumer/lantern.yaml ${SOURCE}/../consumer/parts DESTINATION ${WORK}/project)
cmake_path(SET sources NORMALIZE ${SOURCE}/../../../..)
foreach(case "CMAKE_SYSTEM_NAME=Linux;directorc would be compiled for Linux" "DIRECTOR_SMALL_INDEX=ON;DIRECTOR_SMALL_INDEX is for a runtime without"
             "DIRECTOR_NO_OBSERVER=ON;DIRECTOR_NO_OBSERVER is for a runtime without")
  list(GET case 0 setting)
  list(GET case 1 refusal)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/refused -G Ninja -D CMAKE_CXX_COMPILER=${COMPILER} -D DIRECTOR_SOURCES=${sources}
                          -D ${setting}
                  OUTPUT_QUIET ERROR_VARIABLE said RESULT_VARIABLE result)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  if(result EQUAL 0 OR NOT said MATCHES "${refusal}")
    message(FATAL_ERROR "with ${setting} the project is not refused:\n${said}")
  endif()
  file(REMOVE_RECURSE ${WORK}/refused)
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/build -G Ninja -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
                        -D DIRECTOR_SOURCES=${sources} -D DIRECTOR_CLANG=OFF
                OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the project is not configured:\n${said}")
endif()
execute_process(COMMAND ninja -C ${WORK}/build -t commands lantern OUTPUT_VARIABLE plan RESULT_VARIABLE result)
foreach(step "-o _deps/director-build/bin/directorc " "directorc generate " "lantern.cpp.o " "-o lantern ")
  if(NOT plan MATCHES "${step}")
    message(FATAL_ERROR "the build does not come to \"${step}\":\n${plan}")
  endif()
endforeach()
