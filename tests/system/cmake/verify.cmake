# SPDX-License-Identifier: MIT
# cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<the project> -D COMPILER=<compiler> -D FLAGS=<its flags> -P verify.cmake
# A mistake in a body that the C++ compiler cannot find stops the build with a finding at its place, in every build until it is corrected. A warning
# is printed, and stops the build only with WERROR.
include(${CMAKE_CURRENT_LIST_DIR}/judge_build.cmake)
file(REMOVE_RECURSE ${WORK})
set(WORK "${WORK}/the $robot") # CMake writes such a path in another way into compile_commands.json
file(COPY ${SOURCE}/ DESTINATION ${WORK}/project)
find_program(ninja ninja)
set(generator "Unix Makefiles")
if(ninja)
  set(generator Ninja)
endif()
set(body ${WORK}/project/legs.cpp)
file(READ ${body} good)

function(configure)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/build -G ${generator} -D CMAKE_CXX_COMPILER=${COMPILER}
                          -D CMAKE_CXX_FLAGS=${FLAGS} -D Director_DIR=${BUILD}/cmake ${ARGN} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# build_with(<old text> <new text> builds|fails [<finding>]): replaces the text in the body and builds. Without <finding> there must be none.
function(build_with old new expected)
  string(REPLACE "${old}" "${new}" text "${good}")
  file(WRITE ${body} "${text}")
  judge_build("${new}" ${expected} "${ARGN}")
  execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 0.1)
endfunction()

# EXCLUDE leaves out test doubles in the same build, by their file, folder or target.
configure()
build_with("" "" fails "doubles/legs_double.cpp:6:9: error: `Walk` sets `Pose` to `fallen`, which it does not declare [undeclared_state_write]")
configure(-D EXCLUDED=doubles/legs_double.cpp)
build_with("" "" builds)
configure(-D EXCLUDED=doubles)
build_with("" "" builds)

set(error "project/legs.cpp:5:7: error: `Walk` sets `Pose` to `fallen`, which it does not declare [undeclared_state_write]")
build_with("Pose::moving" "Pose::fallen" fails "${error}")
build_with("Pose::moving" "Pose::fallen" fails "${error}")
build_with("Pose::moving" "Pose::standing" builds)

set(warning "project/walker.yaml:6:65: warning: no path of `Walk` requests `Step` [task_never_requested]")
build_with("request(walker::Step{})" "done()" builds "${warning}")
# A body with a path without an answer does not compile, also if its header is precompiled.
set(path_without "if (pose == walker::Pose::standing) return run.request(walker::Step{})")
build_with("return run.request(walker::Step{})" "${path_without}" fails "return-type")
configure(-D PRECOMPILED=ON)
build_with("return run.request(walker::Step{})" "${path_without}" fails "return-type")
build_with("" "" builds)
file(TOUCH ${WORK}/project/none.cpp)
configure(-D IN_LIBRARY=ON)
build_with("return run.request(walker::Step{})" "${path_without}" fails "return-type")
build_with("" "" builds)
configure(-D PRECOMPILED=OFF -D IN_LIBRARY=OFF)

file(READ ${WORK}/project/doubles/legs_double.cpp double)
file(REMOVE ${WORK}/project/doubles/legs_double.cpp)
file(TOUCH ${WORK}/project/doubles/legs_double.cpp) # empty: nothing is excluded below, so the double would give a finding in every build
configure(-D EXCLUDED= -D STRICT=ON)
string(REPLACE "warning:" "error:" error "${warning}")
build_with("request(walker::Step{})" "done()" fails "${error}")
build_with("" "" builds)
# What another target compiles is read again too.
file(WRITE ${WORK}/project/doubles/legs_double.cpp "${double}")
judge_build("a body of another target" fails "doubles/legs_double.cpp:6:9: error: `Walk` sets `Pose` to `fallen`")
file(WRITE ${WORK}/project/doubles/legs_double.cpp "")
judge_build("no body of another target" builds "")
