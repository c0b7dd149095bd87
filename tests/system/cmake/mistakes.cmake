# SPDX-License-Identifier: MIT
# cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<the project> -D COMPILER=<compiler> -P mistakes.cmake
# Compares the error messages for wrong calls of director_add_behaviour, director_add_docs and find_package(Director). Whole messages are compared,
# after each sequence of white space, where CMake breaks lines, was replaced by one space.
file(REMOVE_RECURSE ${WORK})
foreach(component runtime compiler live)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/whole --component ${component} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(component runtime compiler)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --component ${component} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
set(wrong "")

function(mistake calls expected)
  cmake_parse_arguments(PARSE_ARGV 2 it "" "COMPONENTS;FUNCTION;PREFIX;LANGUAGES" "OPTIONS")
  if(NOT it_FUNCTION)
    set(it_FUNCTION director_add_behaviour)
  endif()
  if(NOT it_PREFIX)
    set(it_PREFIX prefix)
  endif()
  if(NOT it_COMPONENTS)
    set(it_COMPONENTS runtime compiler)
  endif()
  if(NOT it_LANGUAGES)
    set(it_LANGUAGES CXX)
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build_${it_PREFIX} -D LANGUAGES=${it_LANGUAGES} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${WORK}/${it_PREFIX}
                          -D "CALLS=${calls}" "-DCOMPONENTS=${it_COMPONENTS}" -D FUNCTION=${it_FUNCTION} ${it_OPTIONS} --no-warn-unused-cli
                  RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(REPLACE "${SOURCE}/" "" said "${said}")
  string(REPLACE "${WORK}/" "" said "${said}")
  if(status EQUAL 0)
    set(said "nothing")
  else()
    string(REGEX REPLACE "^.*(${it_FUNCTION}:.*) Call Stack.*$" "\\1" said "${said}")
    string(REGEX REPLACE "^.*NOT FOUND. Reason given by package: (.*[^ ]) *$" "\\1" said "${said}")
  endif()
  if(NOT said STREQUAL expected)
    set(wrong "${wrong}\n(${calls})\n  says:   ${said}\n  not:    ${expected}" PARENT_SCOPE)
  endif()
endfunction()

set(usage "director_add_behaviour(<target> <file.yaml> [WERROR] [VERIFY [EXCLUDE <target or path>...]] [STUBS <folder>] [PAGE [LINK <address>]])")
mistake("robot" "director_add_behaviour: the target and the behaviour's file are needed: ${usage}")
mistake("robot kiosk.yaml counter.yaml" "director_add_behaviour: unknown: counter.yaml; it is ${usage}, called once for each behaviour")
mistake("robot kiosk.yaml VERFY" "director_add_behaviour: unknown: VERFY; it is ${usage}, called once for each behaviour")
mistake("robot kiosk.yaml STUBS" "director_add_behaviour: STUBS needs the folder that the stubs go to: ${usage}")
mistake("robot kiosk.yaml STUBS \"\"" "director_add_behaviour: STUBS needs the folder that the stubs go to: ${usage}")
mistake("robot kiosk.yaml PAGE LINK" "director_add_behaviour: LINK needs the address of a line, with {file} and {line} in it: ${usage}")
mistake("robot kiosk.yaml PAGE LINK \"\"" "director_add_behaviour: LINK needs the address of a line, with {file} and {line} in it: ${usage}")
mistake("robot kiosk.yaml LINK a" "director_add_behaviour: LINK says what places on the page lead to, and there is no PAGE: ${usage}")
mistake("robot kiosk.yaml VERIFY EXCLUDE" "director_add_behaviour: EXCLUDE needs targets, files or folders: ${usage}")
mistake("robot kiosk.yaml VERIFY EXCLUDE \"\"" "director_add_behaviour: EXCLUDE needs targets, files or folders: ${usage}")
mistake("robot kiosk.yaml EXCLUDE headers" "director_add_behaviour: EXCLUDE says what VERIFY does not look at, and there is no VERIFY: ${usage}")
mistake("robt kiosk.yaml" "director_add_behaviour: there is no target robt; add_executable or add_library comes first")
mistake("other_name kiosk.yaml" "director_add_behaviour: other_name is only another name; say robot")
mistake("headers kiosk.yaml"
        "director_add_behaviour: headers compiles nothing, so that nothing can be added to it; it takes an executable or a library with sources")
mistake("robot kiosc.yaml"
        "director_add_behaviour: there is no file kiosc.yaml; a relative path begins at the folder of the CMakeLists.txt that calls")
mistake("robot ../mistakes" "director_add_behaviour: ${SOURCE} is a folder; name the behaviour's file in it")
mistake("robot counter.yaml"
        "director_add_behaviour: counter.yaml has no line `behaviour: NAME` that begins in the first column; only a behaviour can be generated, not a module alone")
mistake("robot kiosk.yaml|robot kiosk.yaml"
        "director_add_behaviour: robot has a behaviour kiosk already; two of one name would be one header and one namespace")
mistake("robot kiosk.yaml STUBS bodies"
        "director_add_behaviour: STUBS adds the target robot_stubs, and the project has a target of that name; give that one another name")
mistake("robot kiosk.yaml VERIFY"
        "director_add_behaviour: VERIFY and STUBS read C++, which director-clang does; install it: the package director-clang, or Director built again where the packages clang-19 libclang-19-dev llvm-19-dev are installed")
mistake("" "the component clang is not installed: it is the package director-clang." COMPONENTS "clang")
mistake("" "there is no component robots; there are runtime, compiler, clang, live and dds." COMPONENTS "runtime;robots")
mistake("" "the component live needs cpp-httplib and pkg-config (libcpp-httplib-dev and pkgconf), and a Director that was built with them." COMPONENTS "live")
if(EXISTS ${WORK}/whole/lib/cmake/Director/DirectorLiveTargets.cmake)
  mistake("" "the component live comes only with the installed runtime: not for another machine than that is for, nor with DIRECTOR_NO_OBSERVER or DIRECTOR_SMALL_INDEX."
          COMPONENTS "runtime;compiler;live" PREFIX whole OPTIONS -D CMAKE_SYSTEM_NAME=Linux -D CMAKE_SYSTEM_PROCESSOR=other)
endif()
mistake("robot kiosk.yaml"
        "director_add_behaviour: the generated code is C++, and the project has no such language; say project(NAME LANGUAGES CXX) with CXX among its languages"
        LANGUAGES C)
mistake("" "the component runtime needs the language CXX: project(NAME LANGUAGES CXX); a project that compiles no C++ finds directorc with COMPONENTS compiler."
        LANGUAGES NONE)
mistake("robot kiosk.yaml WERROR" "nothing")
mistake("robot kiosk.yaml PAGE LINK a" "nothing")
set(usage "director_add_docs(<target> <file.yaml>... [FORMAT html|markdown] [OUTPUT <folder>] [LINK <address>] [BUILD <folder>])")
mistake("pages" "director_add_docs: the target and a behaviour's file are needed: ${usage}" FUNCTION director_add_docs)
mistake("pages kiosk.yaml FORMAT" "director_add_docs: nothing stands behind FORMAT: ${usage}" FUNCTION director_add_docs)
mistake("pages kiosk.yaml LINK \"\"" "director_add_docs: nothing stands behind LINK: ${usage}" FUNCTION director_add_docs)
mistake("pages kiosk.yaml FORMAT pdf" "director_add_docs: there is no format pdf: ${usage}" FUNCTION director_add_docs)
mistake("robot kiosk.yaml" "director_add_docs: there is a target robot already; the pages are a target of their own" FUNCTION director_add_docs)
mistake("pages kiosc.yaml" "director_add_docs: there is no file kiosc.yaml; a relative path begins at the folder of the CMakeLists.txt that calls"
        FUNCTION director_add_docs)
mistake("pages kiosk.yaml" "nothing" FUNCTION director_add_docs)
mistake("pages kiosk.yaml" "nothing" FUNCTION director_add_docs COMPONENTS compiler LANGUAGES NONE)
if(wrong)
  message(FATAL_ERROR "${wrong}")
endif()
