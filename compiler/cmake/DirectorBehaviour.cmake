# SPDX-License-Identifier: MIT
# director_add_behaviour(<target> <file.yaml> [WERROR] [VERIFY [EXCLUDE <target or path>...]] [STUBS <folder>] [PAGE [LINK <address>]])
#
# Checks the behaviour with directorc, generates its C++ into the build tree and makes it part of <target>: its sources, its include path (so that
# `#include "<behaviour>.hpp"` finds the header) and the runtime. The headers that the behaviour names are found on the target's include path, and
# beside the file; where director-clang is, the types of C++ that the behaviour names are looked up in them. Findings of level error stop the build. The C++ is generated again when the file,
# anything it imports, or directorc itself changes, and only then; what is the same afterwards is not compiled again. A target may have several
# behaviours, and a behaviour may be part of several targets.
#
#   WERROR          warnings stop the build as errors do
#   VERIFY          after <target> is compiled, its bodies are held against the behaviour (directorc verify); errors stop the build
#   EXCLUDE ...     what VERIFY does not look at, such as test doubles in the same build: targets that are there before this call, files, and folders with
#                   all below them
#   STUBS <folder>  the target <target>_stubs, to be built when wanted, writes into <folder> what bodies are missing (directorc stubs). A build does
#                   not: it writes nothing outside of its tree
#   PAGE            the page about the behaviour (directorc docs) is compiled into <target>: #include "<behaviour>_page.hpp" declares
#                   std::string_view director::pages::<behaviour>(), for director::LiveView. Needs the program dot of Graphviz
#   LINK <address>  behind PAGE: each place there becomes a link, with {file} and {line} in it
#
# VERIFY and STUBS need director-clang, and a generator that writes compile_commands.json: Ninja or Makefiles.
#
# The behaviour's name, which names the outputs, is read from the file's key `behaviour` when CMake configures.

# Not those of whoever calls: how a depfile is read depends on them.
cmake_policy(PUSH)
cmake_policy(VERSION 3.20...3.25)

function(director_add_behaviour)
  set(usage "director_add_behaviour(<target> <file.yaml> [WERROR] [VERIFY [EXCLUDE <target or path>...]] [STUBS <folder>] [PAGE [LINK <address>]])")
  cmake_parse_arguments(PARSE_ARGV 0 arg "WERROR;VERIFY;PAGE" "STUBS;LINK" "EXCLUDE")
  list(LENGTH arg_UNPARSED_ARGUMENTS count)
  if(count LESS 2)
    message(FATAL_ERROR "director_add_behaviour: the target and the behaviour's file are needed: ${usage}")
  endif()
  if(count GREATER 2)
    list(SUBLIST arg_UNPARSED_ARGUMENTS 2 -1 unknown)
    list(JOIN unknown " " unknown)
    message(FATAL_ERROR "director_add_behaviour: unknown: ${unknown}; it is ${usage}, called once for each behaviour")
  endif()
  if("STUBS" IN_LIST arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "director_add_behaviour: STUBS needs the folder that the stubs go to: ${usage}")
  endif()
  if("LINK" IN_LIST arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "director_add_behaviour: LINK needs the address of a line, with {file} and {line} in it: ${usage}")
  endif()
  if(arg_LINK AND NOT arg_PAGE)
    message(FATAL_ERROR "director_add_behaviour: LINK says what places on the page lead to, and there is no PAGE: ${usage}")
  endif()
  if("EXCLUDE" IN_LIST arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "director_add_behaviour: EXCLUDE needs targets, files or folders: ${usage}")
  endif()
  if(arg_EXCLUDE AND NOT arg_VERIFY)
    message(FATAL_ERROR "director_add_behaviour: EXCLUDE says what VERIFY does not look at, and there is no VERIFY: ${usage}")
  endif()
  list(GET arg_UNPARSED_ARGUMENTS 0 target)
  list(GET arg_UNPARSED_ARGUMENTS 1 given)

  if(NOT TARGET ${target})
    message(FATAL_ERROR "director_add_behaviour: there is no target ${target}; add_executable or add_library comes first")
  endif()
  get_target_property(aliased ${target} ALIASED_TARGET)
  if(aliased)
    message(FATAL_ERROR "director_add_behaviour: ${target} is only another name; say ${aliased}")
  endif()
  get_target_property(type ${target} TYPE)
  get_target_property(imported ${target} IMPORTED)
  if(imported OR NOT type MATCHES "^(EXECUTABLE|(STATIC|SHARED|MODULE|OBJECT)_LIBRARY)$")
    message(FATAL_ERROR "director_add_behaviour: ${target} compiles nothing, so that nothing can be added to it; it takes an executable or a library with sources")
  endif()

  cmake_path(ABSOLUTE_PATH given BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE OUTPUT_VARIABLE file)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "director_add_behaviour: there is no file ${file}; a relative path begins at the folder of the CMakeLists.txt that calls")
  endif()
  if(IS_DIRECTORY ${file})
    message(FATAL_ERROR "director_add_behaviour: ${file} is a folder; name the behaviour's file in it")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} keys REGEX "^(behaviour|\"behaviour\"|'behaviour')[ \t]*:")
  string(REGEX MATCH "^[\"']?behaviour[\"']?[ \t]*:[ \t]*[\"']?([A-Za-z_][A-Za-z0-9_]*)" found "${keys}")
  if(NOT found)
    message(FATAL_ERROR "director_add_behaviour: ${file} has no key behaviour at its top level; only a behaviour can be generated, not a module alone")
  endif()
  set(behaviour ${CMAKE_MATCH_1})
  set(page "")

  get_target_property(others ${target} DIRECTOR_BEHAVIOURS)
  if(others AND behaviour IN_LIST others)
    message(FATAL_ERROR "director_add_behaviour: ${target} has a behaviour ${behaviour} already; two of one name would be one header and one namespace")
  endif()
  set_property(TARGET ${target} APPEND PROPERTY DIRECTOR_BEHAVIOURS ${behaviour})

  if(NOT TARGET Director::directorc)
    message(FATAL_ERROR "director_add_behaviour: there is no directorc; find_package(Director COMPONENTS compiler runtime REQUIRED) finds it")
  endif()
  set(werror "")
  if(arg_WERROR)
    set(werror --werror)
  endif()

  # directorc leaves a file alone that says the same already, so what tells that it ran is a file of its own.
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/director/${target}/${behaviour})
  set(outputs ${folder}/${behaviour}.hpp ${folder}/${behaviour}.facts.hpp ${folder}/${behaviour}.cpp ${folder}/manifest.json)
  set(stamp ${folder}/generated)
  set(flags ${folder}/flags)
  if(CMAKE_CONFIGURATION_TYPES) # several builds in one tree, and flags for each
    string(APPEND flags .$<CONFIG>)
  endif()
  director_write_flags_(${target} ${flags})
  string(APPEND flags .CXX)
  add_custom_command(
    OUTPUT ${stamp}
    BYPRODUCTS ${outputs}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND Director::directorc generate ${file} -o ${folder} --depfile ${stamp}.d --depfile-target ${stamp} --flags ${flags} ${werror}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${file} ${flags} $<TARGET_FILE:Director::directorc>
    DEPFILE ${stamp}.d
    COMMENT "Generating the behaviour ${behaviour}"
    VERBATIM)
  if(arg_PAGE)
    director_write_page_(${behaviour} ${file} ${folder} ${stamp} "${arg_LINK}" page)
    list(APPEND outputs ${page})
  endif()
  get_target_property(home ${target} SOURCE_DIR)
  if(home STREQUAL CMAKE_CURRENT_SOURCE_DIR)
    target_sources(${target} PRIVATE ${outputs} ${stamp})
  else()
    # Only targets of one folder share commands.
    add_custom_target(${target}_${behaviour}_generated DEPENDS ${stamp} ${page})
    add_dependencies(${target} ${target}_${behaviour}_generated)
    target_sources(${target} PRIVATE ${outputs})
    set_source_files_properties(${outputs} TARGET_DIRECTORY ${target} PROPERTIES GENERATED TRUE)
  endif()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${folder}>)
  # For `#include "..."` alone, so that nothing in this folder can stand for a header of the system.
  cmake_path(GET file PARENT_PATH beside)
  target_compile_options(${target} PUBLIC $<BUILD_INTERFACE:$<$<COMPILE_LANGUAGE:C,CXX>:-iquote${beside}>>)
  target_link_libraries(${target} PUBLIC Director::core)
  # The generated header makes a missing answer an error; g++ forgets that where the header is a precompiled one.
  set(precompiled "$<OR:$<BOOL:$<TARGET_PROPERTY:${target},PRECOMPILE_HEADERS>>,$<BOOL:$<TARGET_PROPERTY:${target},PRECOMPILE_HEADERS_REUSE_FROM>>>")
  target_compile_options(${target} PRIVATE $<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,${precompiled}>:-Werror=return-type>)

  if(arg_VERIFY OR arg_STUBS)
    director_need_clang_(${target})
  endif()
  if(arg_VERIFY)
    # Objects are compiled again whenever a body, or what it includes, changes; so is this done again.
    set(verified ${folder}/verified)
    set(excluded "")
    foreach(each IN LISTS arg_EXCLUDE)
      director_excluded_(${each} path)
      list(APPEND excluded --exclude ${path})
    endforeach()
    add_custom_command(
      OUTPUT ${verified}
      COMMAND Director::directorc verify ${file} -p ${CMAKE_BINARY_DIR} --generated ${folder} ${excluded} ${werror}
      COMMAND ${CMAKE_COMMAND} -E touch ${verified}
      DEPENDS ${file} ${stamp} $<TARGET_OBJECTS:${target}> $<TARGET_FILE:Director::directorc> $<TARGET_FILE:Director::director-clang>
      COMMENT "Verifying the bodies of the behaviour ${behaviour}"
      VERBATIM COMMAND_EXPAND_LISTS)
    add_custom_target(${target}_${behaviour}_verified ALL DEPENDS ${verified})
    add_dependencies(${target}_${behaviour}_verified ${target})
  endif()
  if(arg_STUBS)
    cmake_path(ABSOLUTE_PATH arg_STUBS BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE OUTPUT_VARIABLE stubs)
    add_custom_target(
      ${target}_${behaviour}_stubs
      COMMAND Director::directorc stubs ${file} -o ${stubs} -p ${CMAKE_BINARY_DIR}
      DEPENDS ${stamp}
      COMMENT "Writing what bodies of the behaviour ${behaviour} are missing into ${stubs}"
      USES_TERMINAL VERBATIM)
    if(NOT TARGET ${target}_stubs)
      add_custom_target(${target}_stubs)
    endif()
    add_dependencies(${target}_stubs ${target}_${behaviour}_stubs)
  endif()
endfunction()

# How the target's headers are compiled, a word in each line: from it directorc reads the values of a state that leaves them to an enum of C++.
function(director_write_flags_ target file)
  separate_arguments(general UNIX_COMMAND "${CMAKE_CXX_FLAGS}")
  list(PREPEND general ${CMAKE_CXX_COMPILER})
  if(CMAKE_SYSROOT)
    list(APPEND general --sysroot=${CMAKE_SYSROOT})
  endif()
  if(CMAKE_CXX_COMPILER_TARGET)
    list(APPEND general --target=${CMAKE_CXX_COMPILER_TARGET})
  endif()
  list(JOIN general "\n" general)
  set(standard $<TARGET_PROPERTY:${target},CXX_STANDARD>)
  set(content "${general}\n-std=c++$<IF:$<VERSION_GREATER:0${standard},20>,${standard},20>\n")
  foreach(what IN ITEMS "-I INCLUDE_DIRECTORIES" "-D COMPILE_DEFINITIONS" " COMPILE_OPTIONS")
    string(REPLACE " " ";" what "${what}")
    list(POP_BACK what property)
    set(value $<TARGET_PROPERTY:${target},${property}>)
    string(APPEND content "$<$<BOOL:${value}>:${what}$<JOIN:${value},\n${what}>>\n")
  endforeach()
  # A condition on the language, in an option, makes a file for each.
  file(GENERATE OUTPUT "${file}.$<COMPILE_LANGUAGE>" CONTENT "${content}" TARGET ${target})
endfunction()

# The page about a behaviour as a source, which is made again where what is generated is.
function(director_write_page_ behaviour file folder stamp link out)
  set(page ${folder}/${behaviour}.html)
  set(source ${folder}/${behaviour}_page.cpp)
  set(header ${behaviour}_page.hpp)
  file(CONFIGURE OUTPUT ${folder}/${header} @ONLY CONTENT "#pragma once
// Written by DirectorBehaviour.cmake: the page about the behaviour, as directorc docs writes it.
#include <string_view>

namespace director::pages {
std::string_view @behaviour@();
}
")
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${CMAKE_SOURCE_DIR}) # as findings and links name it
  set(linked "")
  if(link)
    set(linked "--link=${link}")
  endif()
  add_custom_command(
    OUTPUT ${source}
    BYPRODUCTS ${page}
    COMMAND Director::directorc docs ${file} -o ${folder} ${linked}
    COMMAND ${CMAKE_COMMAND} -D PAGE=${page} -D HEADER=${header} -D FUNCTION=director::pages::${behaviour} -D OUT=${source}
            -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_page.cmake
    DEPENDS ${stamp} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_page.cmake
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
    COMMENT "Writing the page about the behaviour ${behaviour}"
    VERBATIM)
  set(${out} ${source} PARENT_SCOPE)
endfunction()

# Where the objects of a target lie, or a file or folder as it is.
function(director_excluded_ what out)
  if(TARGET ${what})
    get_target_property(real ${what} ALIASED_TARGET)
    if(NOT real)
      set(real ${what})
    endif()
    get_target_property(home ${real} BINARY_DIR)
    set(${out} ${home}/CMakeFiles/${real}.dir PARENT_SCOPE)
    return()
  endif()
  cmake_path(ABSOLUTE_PATH what BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE OUTPUT_VARIABLE path)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "director_add_behaviour: EXCLUDE ${what}: there is no such target yet, nor a file or folder ${path}")
  endif()
  set(${out} ${path} PARENT_SCOPE)
endfunction()

# What reads C++ needs director-clang, and to know how the target's files are compiled.
function(director_need_clang_ target)
  if(NOT TARGET Director::director-clang)
    message(FATAL_ERROR "director_add_behaviour: VERIFY and STUBS read C++, which director-clang does; install it: the package director-clang, or "
                        "Director built again where the packages clang-19 libclang-19-dev llvm-19-dev are installed")
  endif()
  if(NOT CMAKE_GENERATOR MATCHES "Ninja|Makefiles")
    message(FATAL_ERROR "director_add_behaviour: VERIFY and STUBS need compile_commands.json, which CMake writes for Ninja and Makefiles only, not for ${CMAKE_GENERATOR}")
  endif()
  set_property(TARGET ${target} PROPERTY EXPORT_COMPILE_COMMANDS ON)
endfunction()

cmake_policy(POP)
