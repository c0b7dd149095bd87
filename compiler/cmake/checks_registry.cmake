# SPDX-License-Identifier: MIT
# cmake -D LIST=<file> -D OUT=<file> -P checks_registry.cmake
# Writes the C++ table of all checks to OUT. Each line of LIST is `runs <page>` or `explains <page>`. A check that runs is a function with the name of
# its page; it takes a CodeInput if the page has the line `Reads: C++`, and else an Input.
file(STRINGS ${LIST} lines)
set(declarations "")
set(entries "")
set(count 0)
foreach(line IN LISTS lines)
  string(REGEX MATCH "^([a-z]+) (.*)$" line "${line}")
  set(kind ${CMAKE_MATCH_1})
  set(page ${CMAKE_MATCH_2})
  cmake_path(GET page STEM id)
  file(READ ${page} text)
  if(text MATCHES "\\)page\"")
    message(FATAL_ERROR "${page}: the page must not hold the characters that end a raw string, )page\"")
  endif()
  set(run nullptr)
  if(kind STREQUAL runs AND text MATCHES "\nReads: C\\+\\+\n")
    set(run "nullptr, ${id}")
    string(APPEND declarations "void ${id}(const CodeInput&, Findings&);\n")
  elseif(kind STREQUAL runs)
    set(run ${id})
    string(APPEND declarations "void ${id}(const Input&, Findings&);\n")
  endif()
  string(APPEND entries "    {\"${id}\", R\"page(${text})page\", ${run}},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE ${OUT} "// Written by compiler/cmake/checks_registry.cmake from the folder compiler/checks.
#include \"compiler/checks/check.hpp\"

#include <array>
#include <span>

namespace director::checks {

${declarations}
namespace {

const std::array<Registered, ${count}> all{{
${entries}}};

} // namespace

std::span<const Registered> registered() { return all; }

} // namespace director::checks
")
