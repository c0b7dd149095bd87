# SPDX-License-Identifier: MIT
# cmake -D PAGE=<file> -D HEADER=<header> -D FUNCTION=<namespace::name> -D OUT=<file> -P embed_page.cmake
# A file as a C++ text, which the function that HEADER declares returns: the reference of the language, and what a page of `directorc docs` has of
# script and style. In pieces that are put together when it is first called: compilers limit the length of a text.
file(READ ${PAGE} text)
if(text MATCHES "\\)page\"")
  message(FATAL_ERROR "${PAGE}: the page must not hold the characters that end a raw string, )page\"")
endif()
set(pieces "")
string(LENGTH "${text}" length)
while(length GREATER 0)
  string(SUBSTRING "${text}" 0 8000 piece)
  if(length GREATER 8000)
    string(REGEX MATCH "^.*[\t\n -~]" whole "${piece}") # not through a character of several bytes, which compilers warn of
    if(NOT whole STREQUAL "")
      set(piece "${whole}")
    endif()
  endif()
  string(APPEND pieces "      R\"page(${piece})page\",\n")
  string(LENGTH "${piece}" taken)
  string(SUBSTRING "${text}" ${taken} -1 text)
  string(LENGTH "${text}" length)
endwhile()
cmake_path(GET PAGE FILENAME name)
file(WRITE ${OUT} "// Written by compiler/cmake/embed_page.cmake from ${name}.
#include \"${HEADER}\"

#include <string>

std::string_view ${FUNCTION}() {
  static const std::string text = [] {
    static const char* const pieces[] = { // not a list in the loop, for which g++ takes ten times as long
${pieces}    };
    std::string all;
    for (const char* piece : pieces) all += piece;
    return all;
  }();
  return text;
}
")
