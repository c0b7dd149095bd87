# SPDX-License-Identifier: MIT
# cmake -D FROM=<folder of the project> -D TO=<folder> -P plant.cmake
# Copies the sources and headers of runtime/core/ to TO and plants all faults of faults.cmake in the copy. TO/planted.hpp tells a program about the
# faults and lets it choose one. What is as before is not written again.

cmake_minimum_required(VERSION 3.25)
set(core ${FROM}/runtime/core)
set(count 0)
set(changed "")
set(rows "")

# read(<place> <out>): the text of a source with the faults that were planted so far.
function(read place out)
  string(MAKE_C_IDENTIFIER ${place} name)
  if(NOT DEFINED text_${name})
    file(READ ${core}/${place} text_${name})
  endif()
  set(${out} "${text_${name}}" PARENT_SCOPE)
endfunction()

# fault(<section> <rule> {<source> <text> <what replaces it>}...)
function(fault section rule)
  math(EXPR number "${count} + 1")
  math(EXPR last "${ARGC} - 1")
  foreach(at RANGE 2 ${last} 3)
    math(EXPR from "${at} + 1")
    math(EXPR to "${at} + 2")
    set(place ${ARGV${at}})
    read(${place} text)
    string(FIND "${text}" "${ARGV${from}}" first)
    string(FIND "${text}" "${ARGV${from}}" again REVERSE)
    if(first EQUAL -1 OR NOT first EQUAL again)
      message(FATAL_ERROR "tests/planted/faults.cmake, fault ${number} (${rule}): this text must occur once in runtime/core/${place}, and does "
                          "not. If the source has changed, change the fault with it:\n${ARGV${from}}")
    endif()
    string(REPLACE "PLANTED" "::director::planted(${number})" planted "${ARGV${to}}")
    string(REPLACE "${ARGV${from}}" "${planted}" text "${text}")
    string(MAKE_C_IDENTIFIER ${place} name)
    set(text_${name} "${text}" PARENT_SCOPE)
    set(text_${name} "${text}")
    list(APPEND changed ${place})
  endforeach()
  set(changed ${changed} PARENT_SCOPE)
  set(count ${number} PARENT_SCOPE)
  set(rows "${rows}    {\"${section}\", \"${rule}\"},\n" PARENT_SCOPE)
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/faults.cmake)

file(CONFIGURE OUTPUT ${TO}/planted.hpp @ONLY CONTENT [[
#pragma once
// Made by tests/planted/plant.cmake.

namespace director {

struct PlantedFault {
  const char* section; ///< of docs/semantics.md
  const char* rule;    ///< that the fault breaks
};

/// The first one is no fault.
inline constexpr PlantedFault planted_faults[] = {
    {"", "none: the engine as it is"},
@rows@};

inline int chosen_fault = 0; ///< an index of planted_faults

inline bool planted(int fault) { return fault == chosen_fault; }

} // namespace director
]])

file(GLOB_RECURSE sources RELATIVE ${core} ${core}/*.cpp ${core}/*.hpp)
foreach(place IN LISTS sources)
  read(${place} text)
  if(place IN_LIST changed)
    string(PREPEND text "#include \"planted.hpp\"\n")
  endif()
  set(before "")
  if(EXISTS ${TO}/runtime/core/${place})
    file(READ ${TO}/runtime/core/${place} before)
  endif()
  if(NOT before STREQUAL text)
    file(WRITE ${TO}/runtime/core/${place} "${text}")
  endif()
endforeach()
