# SPDX-License-Identifier: MIT
# cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<the project> -D COMPILER=<compiler> -D FLAGS=<its flags> -P first.cmake
# The first program of docs/building.md: a behaviour and the files that `directorc stubs --main` writes give a program. Then the lines that the page
# adds make it print its decisions, and add a scenario as a test.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(REMOVE_RECURSE ${WORK})
file(COPY ${SOURCE}/ DESTINATION ${WORK})
set(program ${WORK}/build/lantern)
function(change file old new)
  file(READ ${WORK}/${file} text)
  string(REPLACE "${old}" "${new}" changed "${text}")
  if(changed STREQUAL text)
    message(FATAL_ERROR "${file} has no ${old}:\n${text}")
  endif()
  file(WRITE ${WORK}/${file} "${changed}")
endfunction()

run(${CMAKE_COMMAND} -E env DIRECTOR_CLANG=none ${BUILD}/bin/directorc stubs lantern.yaml -o . --main)
run(${CMAKE_COMMAND} -S . -B build -G Ninja -D Director_DIR=${BUILD}/cmake -D CMAKE_CXX_COMPILER=${COMPILER}
    "-DCMAKE_CXX_FLAGS=${FLAGS} -Wall -Wextra -Wconversion -Wshadow -Werror")
run(${CMAKE_COMMAND} --build build)

change(lantern_module.cpp "Shine::Default& run) {\n  return run.keep(); // does nothing yet"
       "Shine::Default& run) {\n  return run.request(lantern::Lamp{});")
change(main.cpp "#include <chrono>" "#include \"runtime/hosted/decision_printer.hpp\"\n\n#include <chrono>")
change(main.cpp "behaviour{lantern_part}" "behaviour{lantern_part, printer.observer()}")
change(main.cpp "  lantern::Behaviour" "  director::DecisionPrinter printer{lantern::names::all()};\n  lantern::Behaviour")
change(main.cpp "  while (stopping == 0)" "  step();\n  stopping = 1; // as if by Ctrl-C\n  while (stopping == 0)")
file(WRITE ${WORK}/scenarios/shine.scenario.yaml
  "behaviour: ../lantern.yaml\nsteps:\n  - request: Shine\n    expect: |\n      run Shine new_task\n      run Lamp new_task\n")
file(APPEND ${WORK}/CMakeLists.txt "target_link_libraries(lantern PRIVATE Director::hosted)\nenable_testing()\n"
  "add_test(NAME scenarios COMMAND $<TARGET_FILE:Director::directorc> test \${CMAKE_CURRENT_SOURCE_DIR}/scenarios)\n")
run(${CMAKE_COMMAND} --build build)
run(${program})
set(expected "> request Shine\nrun Shine new_task\nrun Lamp new_task\n> cancel Shine\n")
if(NOT said STREQUAL expected)
  message(FATAL_ERROR "the program said:\n${said}")
endif()

cmake_path(GET CMAKE_COMMAND PARENT_PATH programs)
run(${programs}/ctest --test-dir build)
if(NOT said MATCHES "1/1 Test .*scenarios.* Passed")
  message(FATAL_ERROR "ctest said:\n${said}")
endif()
