# SPDX-License-Identifier: MIT
# Functions for the CMakeLists.txt of the components. A component is a folder of sources that becomes one static library; its sources are globbed, so
# that a new file needs no change of a CMake file.

# The warning options of Director's own code. They are linked privately, so projects that link a component do not get them.
add_library(director_warnings INTERFACE)
target_compile_options(director_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                                                   $<$<BOOL:${DIRECTOR_WERROR}>:-Werror>)
# At -O3 GCC 12 wrongly warns that "text" + std::string copies between overlapping ranges (GCC bug 105651).
target_compile_options(director_warnings INTERFACE $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
# Clang reports std::stable_sort in our code, because libstdc++ 12 calls a deprecated function in it.
target_compile_options(director_warnings INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)

# director_component(<target> <alias> FOLDER <folder> [TOGETHER] [EXCLUDE <regex>...] [ALONE <source>...] [LINK <library>...] [PRIVATE_LINK <library>...])
# Adds the static library <target>, with the alias Director::<alias>, from all sources below FOLDER.
# TOGETHER: the sources are compiled in unity builds if DIRECTOR_TOGETHER is on, except those that ALONE names. Without TOGETHER each source becomes
# an object file of its own, which the linker can leave out. A component that has no source yet is an interface library, so that others can link it
# already.
function(director_component target alias)
  cmake_parse_arguments(component "TOGETHER" "FOLDER" "EXCLUDE;ALONE;LINK;PRIVATE_LINK" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${component_FOLDER}/*.cpp)
  foreach(pattern IN LISTS component_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX ${pattern})
  endforeach()
  if(sources)
    add_library(${target} STATIC ${sources})
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/director>)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_link_libraries(${target} PUBLIC ${component_LINK} PRIVATE ${component_PRIVATE_LINK})
    # This copies the options instead of linking director_warnings: a linked library would have to be installed with the component.
    target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:director_warnings,INTERFACE_COMPILE_OPTIONS>)
    if(DIRECTOR_FUZZABLE)
      target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    if(component_TOGETHER)
      # -O1 with only those optimisations of -O2 that make the compiler faster: the inlining. The others took a fifth of the time that g++ needs for a
      # source.
      target_compile_options(${target} PRIVATE
                             "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-O1;-finline-small-functions;-findirect-inlining;-fpartial-inlining>")
    endif()
    if(DIRECTOR_TOGETHER AND component_TOGETHER)
      director_component_together(${target} ${component_FOLDER} "${component_ALONE}" ${sources})
    endif()
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                   $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/director>)
    target_compile_features(${target} INTERFACE cxx_std_20)
    target_link_libraries(${target} INTERFACE ${component_LINK})
  endif()
  add_library(Director::${alias} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${alias})
endfunction()

# director_component_together(<target> <component's folder> <sources that stay alone> <source>...): compiles the sources of a component in unity builds.
function(director_component_together target folder_of_all alone)
  # In a unity build a local variable may have the name of a function or constant of another source, so only a name that hides a local one is reported.
  target_compile_options(${target} PRIVATE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
  director_compile_together(${target} 64 ${folder_of_all} "${alone}" ${ARGN})
endfunction()

# director_compile_together(<target> <most> <component's folder> <sources that stay alone> <source>...): compiles the sources in unity builds of at
# most <most> files. Each contains only sources of one top-level folder of the component and its subfolders. This saves time, because the compiler
# spends most of it on templates of the standard library, which each translation unit instantiates again.
function(director_compile_together target most folder_of_all alone)
  set(groups "")
  foreach(source IN LISTS ARGN)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${folder_of_all} OUTPUT_VARIABLE place)
    if(place IN_LIST alone)
      continue()
    endif()
    string(REGEX MATCH "^[^/]+/" folder ${place})
    string(MAKE_C_IDENTIFIER "group_${folder}" group)
    list(APPEND groups ${group})
    list(APPEND ${group} ${source})
  endforeach()
  list(REMOVE_DUPLICATES groups)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(group IN LISTS groups)
    set(number 0)
    while(${group})
      math(EXPR number "${number} + 1")
      list(SUBLIST ${group} 0 ${most} few)
      set_source_files_properties(${few} PROPERTIES UNITY_GROUP ${group}${number})
      list(REMOVE_ITEM ${group} ${few})
    endwhile()
  endforeach()
endfunction()
