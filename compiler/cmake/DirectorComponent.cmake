# SPDX-License-Identifier: MIT
# What the components' CMakeLists.txt share. A component is a folder of sources that becomes one static library; its files are globbed, so that adding a file
# touches no CMake file.

# Warnings for Director's own code only: nothing of it reaches who links a component.
add_library(director_warnings INTERFACE)
target_compile_options(director_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                                                   $<$<BOOL:${DIRECTOR_WERROR}>:-Werror>)
# At -O3 GCC 12 takes "text" + std::string for a copy that overlaps itself (its bug 105651).
target_compile_options(director_warnings INTERFACE $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
# Clang blames whoever sorts stably for a deprecated function that libstdc++ 12 itself calls.
target_compile_options(director_warnings INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)

# director_component(<target> <alias> FOLDER <folder> [TOGETHER] [EXCLUDE <regex>...] [ALONE <source>...] [LINK <library>...] [PRIVATE_LINK <library>...])
# TOGETHER: several of its sources are compiled as one, with DIRECTOR_TOGETHER; ALONE names those that cannot be. Without it each source is an object
# of its own, which a linker can leave out. A component without a source yet is an interface library, so that components can be written in any order.
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
    # Its options, not the library itself: who installs a component does not have to install the warnings.
    target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:director_warnings,INTERFACE_COMPILE_OPTIONS>)
    if(DIRECTOR_FUZZABLE)
      target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    if(component_TOGETHER)
      # Of -O2 what makes the compiler faster, which is the inlining. All else of it took g++ a fifth of the time to compile a source.
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

# director_component_together(<target> <component's folder> <sources that stay alone> <source>...): a component's sources, compiled together.
function(director_component_together target folder_of_all alone)
  # A local name may be one of another source, but not that of an outer block.
  target_compile_options(${target} PRIVATE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
  director_compile_together(${target} 64 ${folder_of_all} "${alone}" ${ARGN})
endfunction()

# director_compile_together(<target> <most> <component's folder> <sources that stay alone> <source>...): the sources of each folder within the component, with
# those below it, up to so many at a time, become one for the compiler. Most of the time that it takes goes into the templates of the standard library, which
# each source instantiates anew.
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
