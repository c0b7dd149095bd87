# SPDX-License-Identifier: MIT
# cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<the project> -D COMPILER=<compiler> -D FLAGS=<its flags> -P types.cmake
# directorc compares the C++ types that the behaviour names with the program's headers before anything is compiled: findings point to the YAML, and an
# error stops the build before the generated code is compiled. The values of a state are those of an enum whose header is found by an option of two
# words, and which has one value less with the flags of the configuration; the page about the behaviour is written with these flags too.
include(${CMAKE_CURRENT_LIST_DIR}/judge_build.cmake)
file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/ DESTINATION ${WORK}/project)
find_program(ninja ninja)
set(generator "Unix Makefiles")
if(ninja)
  set(generator Ninja)
endif()
foreach(name types.hpp lift.yaml)
  file(READ ${WORK}/project/${name} good_${name})
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/build -G ${generator} -D CMAKE_CXX_COMPILER=${COMPILER}
                        -D CMAKE_CXX_FLAGS=${FLAGS} -D CMAKE_BUILD_TYPE=Release -D Director_DIR=${BUILD}/cmake OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# build_with(<file> <old text> <new text> builds|fails [<finding>]): replaces the text in the file and builds. Without <finding> there must be none.
function(build_with name old new expected)
  foreach(each types.hpp lift.yaml)
    file(READ ${WORK}/project/${each} text)
    if(NOT text STREQUAL good_${each})
      file(WRITE ${WORK}/project/${each} "${good_${each}}")
    endif()
  endforeach()
  string(REPLACE "${old}" "${new}" text "${good_${name}}")
  file(WRITE ${WORK}/project/${name} "${text}")
  judge_build("${new}" ${expected} "${ARGN}")
  if(NOT "${ARGN}" MATCHES "warning" AND output MATCHES "director/lift/lift/[^\n]*error")
    message(FATAL_ERROR "with ${new} there is an error in generated code:\n${output}")
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 0.1)
endfunction()

build_with(types.hpp "" "" builds)
build_with(types.hpp "shut" "shut, stuck" fails
           "project/lift.yaml:4:23: error: `lift::Door` has `stuck`, which the values of `Door` lack [enum_drift]")
build_with(types.hpp "Floor" "Storey" fails
           "project/lift.yaml:8:11: error: there is no type `lift::Floor` in the C++: no type named 'Floor' in namespace 'lift' [unknown_type]")
build_with(lift.yaml "lift::Door," "lift::Dor," fails
           "project/lift.yaml:4:23: error: there is no type `lift::Dor` in the C++: no type named 'Dor' in namespace 'lift'")
build_with(lift.yaml "types.hpp," "types.hpp, lift.hpp," fails "project/lift.yaml:3:28: error: a header cannot be called `lift.hpp`")
build_with(lift.yaml "types.hpp," "types.hpp, gone.hpp," fails
           "project/lift.yaml:3:28: warning: no include folder of the program has `gone.hpp` [missing_header]")
build_with(types.hpp "" "" builds)
