# SPDX-License-Identifier: MIT
# cmake -D PAGE=<file> -D HEADER=<header> -D FUNCTION=<namespace::name> -D OUT=<file> -P embed_page.cmake
# Writes a C++ source to OUT that defines FUNCTION, which HEADER declares and which returns the text of the file PAGE: the reference of the language,
# a script or style sheet of the pages of `directorc docs`, or such a page. The text is split into several string literals, because compilers limit
# their length; FUNCTION joins them at its first call.
file(READ ${PAGE} text)
if(text MATCHES "\\)page\"")
  message(FATAL_ERROR "${PAGE}: the page must not hold the characters that end a raw string, )page\"")
endif()
set(pieces "")
string(LENGTH "${text}" length)
while(length GREATER 0)
  string(SUBSTRING "${text}" 0 8000 piece)
  if(length GREATER 8000)
    string(REGEX MATCH "^.*[\t\n -~]" whole "${piece}") # end at an ASCII character: compilers warn of a literal with a part of a multi-byte character
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
