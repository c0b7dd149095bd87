# SPDX-License-Identifier: MIT
# director_add_behaviour(<target> <file.yaml> [WERROR] [VERIFY [EXCLUDE <target or path>...]] [BOUND <states>] [STUBS <folder>] [PAGE [LINK <address>]])
#
# Checks the behaviour with directorc, generates its C++ into the build tree and adds it to <target>: the generated sources, the include folder of the
# generated header (`#include "<behaviour>.hpp"`) and the runtime. The headers that the behaviour names are searched in the target's include folders,
# and in the folder of the behaviour's file; if director-clang is installed, directorc looks up the C++ types that the behaviour names in these
# headers. Findings of level error stop the build. The C++ is generated again only when the file, a file that it imports, a header in which directorc
# looked up types, directorc itself or the target's compile flags change; generated files whose content stays the same are not compiled again. A
# target may have several behaviours, and a behaviour may be added to several targets.
#
#   WERROR          warnings stop the build as errors do
#   VERIFY          after <target> is compiled, `directorc verify` compares its bodies with the behaviour; errors stop the build
#   EXCLUDE ...     what VERIFY leaves out, such as test doubles in the same build: targets that exist before this call, files, and folders with everything
#                   below them
#   BOUND <states>  decides the assertions within so many states instead of 100000 (directorc generate --bound)
#   STUBS <folder>  adds the target <target>_stubs, which is built only on request and writes the missing bodies into <folder> (directorc stubs). A normal
#                   build writes nothing outside of the build tree
#   PAGE            compiles the page about the behaviour (directorc docs) into <target>: the header "<behaviour>_page.hpp" declares
#                   std::string_view director::pages::<behaviour>(), for director::LiveView. Needs the program dot of Graphviz
#   LINK <address>  with PAGE: the address of a line, with {file} and {line} in it. Each place that the page names becomes a link
#
# VERIFY and STUBS need director-clang, and a generator that writes compile_commands.json: Ninja or Makefiles.
#
# The name of the behaviour, after which the generated files are named, is read from the key `behaviour` of the file when CMake configures.

# The module sets its own policies, not those of the calling project: policies determine how paths in a depfile are interpreted.
cmake_policy(PUSH)
cmake_policy(VERSION 3.20...3.25)

function(director_add_behaviour)
  set(usage "director_add_behaviour(<target> <file.yaml> [WERROR] [VERIFY [EXCLUDE <target or path>...]] [BOUND <states>] [STUBS <folder>] [PAGE [LINK <address>]])")
  cmake_parse_arguments(PARSE_ARGV 0 arg "WERROR;VERIFY;PAGE" "BOUND;STUBS;LINK" "EXCLUDE")
  list(LENGTH arg_UNPARSED_ARGUMENTS count)
  if(count LESS 2)
    message(FATAL_ERROR "director_add_behaviour: the target and the behaviour's file are needed: ${usage}")
  endif()
  if(count GREATER 2)
    list(SUBLIST arg_UNPARSED_ARGUMENTS 2 -1 unknown)
    list(JOIN unknown " " unknown)
    message(FATAL_ERROR "director_add_behaviour: unknown: ${unknown}; it is ${usage}, called once for each behaviour")
  endif()
  # A keyword with an empty value, such as a variable that is not set, is not in arg_KEYWORDS_MISSING_VALUES.
  if("STUBS" IN_LIST ARGV AND "${arg_STUBS}" STREQUAL "")
    message(FATAL_ERROR "director_add_behaviour: STUBS needs the folder that the stubs go to: ${usage}")
  endif()
  if("BOUND" IN_LIST ARGV AND NOT "${arg_BOUND}" MATCHES "^[1-9][0-9]*$")
    message(FATAL_ERROR "director_add_behaviour: BOUND needs a number of states, such as 1000000: ${usage}")
  endif()
  if("LINK" IN_LIST ARGV AND "${arg_LINK}" STREQUAL "")
    message(FATAL_ERROR "director_add_behaviour: LINK needs the address of a line, with {file} and {line} in it: ${usage}")
  endif()
  if(arg_LINK AND NOT arg_PAGE)
    message(FATAL_ERROR "director_add_behaviour: LINK says what places on the page lead to, and there is no PAGE: ${usage}")
  endif()
  if("EXCLUDE" IN_LIST ARGV AND "${arg_EXCLUDE}" STREQUAL "")
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

  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(NOT "CXX" IN_LIST languages)
    message(FATAL_ERROR "director_add_behaviour: the generated code is C++, and the project has no such language; say project(NAME LANGUAGES CXX) with CXX among its languages")
  endif()

  cmake_path(ABSOLUTE_PATH given BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE OUTPUT_VARIABLE file)
  if(NOT EXISTS ${file})
    cmake_path(IS_ABSOLUTE given is_absolute)
    if(is_absolute)
      message(FATAL_ERROR "director_add_behaviour: there is no file ${file}; it must exist when CMake configures")
    endif()
    message(FATAL_ERROR "director_add_behaviour: there is no file ${file}; a relative path begins at the folder of the CMakeLists.txt that calls")
  endif()
  if(IS_DIRECTORY ${file})
    message(FATAL_ERROR "director_add_behaviour: ${file} is a folder; name the behaviour's file in it")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  # Without ENCODING, CMake takes what stands behind a character outside of ASCII for a line of its own.
  file(STRINGS ${file} keys ENCODING UTF-8 REGEX "^(behaviour|\"behaviour\"|'behaviour')[ \t]*:")
  string(REGEX MATCH "^[\"']?behaviour[\"']?[ \t]*:[ \t]*[\"']?([A-Za-z_][A-Za-z0-9_]*)" found "${keys}")
  if(NOT found)
    message(FATAL_ERROR "director_add_behaviour: ${file} has no line `behaviour: NAME` that begins in the first column; only a behaviour can be generated, not a module alone")
  endif()
  set(behaviour ${CMAKE_MATCH_1})
  set(page_stamp "")

  get_target_property(others ${target} DIRECTOR_BEHAVIOURS)
  if(others AND behaviour IN_LIST others)
    message(FATAL_ERROR "director_add_behaviour: ${target} has a behaviour ${behaviour} already; two of one name would be one header and one namespace")
  endif()
  set_property(TARGET ${target} APPEND PROPERTY DIRECTOR_BEHAVIOURS ${behaviour})
  if(arg_STUBS AND TARGET ${target}_stubs)
    get_target_property(own ${target}_stubs DIRECTOR_STUBS)
    if(NOT own) # to build the project's own target would write into the source tree
      message(FATAL_ERROR "director_add_behaviour: STUBS adds the target ${target}_stubs, and the project has a target of that name; give that one another name")
    endif()
  endif()

  if(NOT TARGET Director::directorc)
    message(FATAL_ERROR "director_add_behaviour: there is no directorc; find_package(Director COMPONENTS compiler runtime REQUIRED) finds it")
  endif()
  set(werror "")
  if(arg_WERROR)
    set(werror --werror)
  endif()
  set(bound "")
  if(arg_BOUND)
    set(bound --bound=${arg_BOUND})
  endif()

  # directorc does not rewrite a file whose content is the same, so a stamp file shows when it ran last.
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/director/${target}/${behaviour})
  set(outputs ${folder}/${behaviour}.hpp ${folder}/${behaviour}.facts.hpp ${folder}/${behaviour}.cpp ${folder}/manifest.json)
  set(stamp ${folder}/generated)
  set(flags ${folder}/flags)
  if(CMAKE_CONFIGURATION_TYPES) # a multi-config generator: each configuration has its own flags
    string(APPEND flags .$<CONFIG>)
  endif()
  director_write_flags_(${target} ${flags})
  string(APPEND flags .CXX)
  add_custom_command(
    OUTPUT ${stamp}
    BYPRODUCTS ${outputs}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND Director::directorc generate ${file} -o ${folder} --depfile ${stamp}.d --depfile-target ${stamp} --flags ${flags} ${werror} ${bound}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${file} ${flags} $<TARGET_FILE:Director::directorc>
    DEPFILE ${stamp}.d
    COMMENT "Generating the behaviour ${behaviour}"
    VERBATIM)
  if(arg_PAGE)
    director_write_page_(${behaviour} ${file} ${folder} ${stamp} ${flags} "${arg_LINK}" "${bound}" page page_stamp)
    list(APPEND outputs ${page})
  endif()
  get_target_property(home ${target} SOURCE_DIR)
  if(home STREQUAL CMAKE_CURRENT_SOURCE_DIR)
    target_sources(${target} PRIVATE ${outputs} ${stamp} ${page_stamp})
  else()
    # The output of a custom command can be a source only of a target in the same directory, so this target needs a custom target to depend on.
    add_custom_target(${target}_${behaviour}_generated DEPENDS ${stamp} ${page_stamp})
    add_dependencies(${target} ${target}_${behaviour}_generated)
    target_sources(${target} PRIVATE ${outputs})
    set_source_files_properties(${outputs} TARGET_DIRECTORY ${target} PROPERTIES GENERATED TRUE)
  endif()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${folder}>)
  # An option comes behind the include folders of the target, and of those that link it, so that no file here hides a header in one of them.
  # (-iquote would go before all of them; headers found by -idirafter count as those of the system.)
  cmake_path(GET file PARENT_PATH beside)
  target_compile_options(${target} PUBLIC $<BUILD_INTERFACE:$<$<COMPILE_LANGUAGE:C,CXX>:-I${beside}>>)
  target_link_libraries(${target} PUBLIC Director::core)
  # A pragma in runtime/core/api/behaviour.hpp makes a body without an answer an error; g++ loses the pragma if that header is in a precompiled header:
  # of this target, or of one that links it and has bodies.
  set(precompiled "$<OR:$<BOOL:$<TARGET_PROPERTY:PRECOMPILE_HEADERS>>,$<BOOL:$<TARGET_PROPERTY:PRECOMPILE_HEADERS_REUSE_FROM>>>")
  target_compile_options(${target} PUBLIC $<BUILD_INTERFACE:$<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,${precompiled}>:-Werror=return-type>>)

  if(arg_VERIFY OR arg_STUBS)
    director_need_clang_(${target})
  endif()
  if(arg_VERIFY)
    # It runs again whenever a body or what that includes changes, also in other targets of the build: what it read.
    set(verified ${folder}/verified)
    set(excluded "")
    foreach(each IN LISTS arg_EXCLUDE)
      director_excluded_(${each} path)
      list(APPEND excluded --exclude ${path})
    endforeach()
    add_custom_command(
      OUTPUT ${verified}
      COMMAND Director::directorc verify ${file} -p ${CMAKE_BINARY_DIR} --generated ${folder} ${excluded} ${werror}
              --depfile ${verified}.d --depfile-target ${verified}
      COMMAND ${CMAKE_COMMAND} -E touch ${verified}
      DEPENDS ${file} ${stamp} $<TARGET_OBJECTS:${target}> $<TARGET_FILE:Director::directorc> $<TARGET_FILE:Director::director-clang>
      DEPFILE ${verified}.d
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
      set_property(TARGET ${target}_stubs PROPERTY DIRECTOR_STUBS TRUE) # several behaviours of a target share it
    endif()
    add_dependencies(${target}_stubs ${target}_${behaviour}_stubs)
  endif()
endfunction()

# director_write_flags_(<target> <file>): writes the compiler and the flags of the target to <file>.CXX, one word a line. With them directorc finds
# the C++ types that the behaviour names, for instance an enum from which a state takes its values.
function(director_write_flags_ target file)
  separate_arguments(general UNIX_COMMAND "${CMAKE_CXX_COMPILER_ARG1} ${CMAKE_CXX_FLAGS}") # the first: of CXX="g++ -m32"
  list(PREPEND general ${CMAKE_CXX_COMPILER})
  if(CMAKE_SYSROOT)
    list(APPEND general --sysroot=${CMAKE_SYSROOT})
  endif()
  if(CMAKE_CXX_COMPILER_TARGET)
    list(APPEND general --target=${CMAKE_CXX_COMPILER_TARGET})
  endif()
  # Each configuration has flags of its own, for instance -DNDEBUG.
  set(configurations ${CMAKE_CONFIGURATION_TYPES})
  if(NOT configurations)
    set(configurations ${CMAKE_BUILD_TYPE})
  endif()
  foreach(configuration IN LISTS configurations)
    string(TOUPPER "${configuration}" name)
    separate_arguments(words UNIX_COMMAND "${CMAKE_CXX_FLAGS_${name}}")
    foreach(word IN LISTS words)
      list(APPEND general $<$<CONFIG:${configuration}>:${word}>)
    endforeach()
  endforeach()
  list(JOIN general "\n" general)
  if(CMAKE_INCLUDE_CURRENT_DIR)
    get_target_property(binary ${target} BINARY_DIR)
    get_target_property(source ${target} SOURCE_DIR)
    string(APPEND general "\n-I${binary}\n-I${source}")
  endif()
  set(standard $<TARGET_PROPERTY:${target},CXX_STANDARD>)
  set(extensions $<TARGET_PROPERTY:${target},CXX_EXTENSIONS>)
  set(usual c)
  if(CMAKE_CXX_EXTENSIONS_DEFAULT)
    set(usual gnu)
  endif()
  set(dialect $<IF:$<STREQUAL:${extensions},>,${usual},$<IF:$<BOOL:${extensions}>,gnu,c>>)
  set(content "${general}\n-std=${dialect}++$<IF:$<VERSION_GREATER:0${standard},20>,${standard},20>\n")
  foreach(what IN ITEMS "-I INCLUDE_DIRECTORIES" "-D COMPILE_DEFINITIONS" " COMPILE_OPTIONS")
    string(REPLACE " " ";" what "${what}")
    list(POP_BACK what property)
    set(value $<TARGET_PROPERTY:${target},${property}>)
    string(APPEND content "$<$<BOOL:${value}>:${what}$<JOIN:${value},\n${what}>>\n")
  endforeach()
  # An option may depend on the language (COMPILE_LANGUAGE), so CMake has to write one file for each language.
  file(GENERATE OUTPUT "${file}.$<COMPILE_LANGUAGE>" CONTENT "${content}" TARGET ${target})
endfunction()

# director_write_page_(<behaviour> <file> <folder> <stamp> <flags> <link> <bound> <out> <out stamp>): sets <out> to a source that contains the page about the
# behaviour, and <out stamp> to a file that is written after it whenever the C++ is generated again. The source itself stays as it is if the page does.
function(director_write_page_ behaviour file folder stamp flags link bound out out_stamp)
  cmake_path(GET file STEM LAST_ONLY stem) # directorc calls a page like the behaviour's file
  set(page ${folder}/${stem}.html)
  set(source ${folder}/${behaviour}_page.cpp)
  set(header ${behaviour}_page.hpp)
  file(CONFIGURE OUTPUT ${folder}/${header} @ONLY CONTENT "#pragma once
// Written by DirectorBehaviour.cmake: the page about the behaviour, as directorc docs writes it.
#include <string_view>

namespace director::pages {
std::string_view @behaviour@();
}
")
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${CMAKE_SOURCE_DIR}) # findings and links on the page contain this path
  set(linked "")
  if(link)
    string(REPLACE ";" "$<SEMICOLON>" link "${link}") # else the command would have an argument for each part
    set(linked "--link=${link}")
  endif()
  set(written ${folder}/page_written)
  add_custom_command(
    OUTPUT ${written}
    BYPRODUCTS ${page} ${source}
    COMMAND Director::directorc docs ${file} -o ${folder} --flags ${flags} ${linked} ${bound}
    COMMAND ${CMAKE_COMMAND} -D PAGE=${page} -D HEADER=${header} -D FUNCTION=director::pages::${behaviour} -D OUT=${source}.new
            -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_page.cmake
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${source}.new ${source}
    COMMAND ${CMAKE_COMMAND} -E touch ${written}
    DEPENDS ${stamp} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_page.cmake
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
    COMMENT "Writing the page about the behaviour ${behaviour}"
    VERBATIM)
  set(${out} ${source} PARENT_SCOPE)
  set(${out_stamp} ${written} PARENT_SCOPE)
endfunction()

# director_excluded_(<what> <out>): sets <out> to the folder of the object files if <what> is a target, and else to the absolute path of the file or
# folder.
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

# director_need_clang_(<target>): makes sure that director-clang exists and that compile_commands.json will contain the target's sources.
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
