# SPDX-License-Identifier: MIT
# cmake -D PAGE=<file> -D OUT=<file> -P embed_page.cmake
# The reference of the language as a C++ text, so that `directorc explain` has the page's own words. In pieces, as compilers limit the length of one.
file(READ ${PAGE} text)
if(text MATCHES "\\)page\"")
  message(FATAL_ERROR "${PAGE}: the page must not hold the characters that end a raw string, )page\"")
endif()
set(pieces "")
string(LENGTH "${text}" length)
while(length GREATER 0)
  string(SUBSTRING "${text}" 0 8000 piece)
  string(APPEND pieces "\n    R\"page(${piece})page\"")
  if(length LESS_EQUAL 8000)
    break()
  endif()
  string(SUBSTRING "${text}" 8000 -1 text)
  string(LENGTH "${text}" length)
endwhile()
file(WRITE ${OUT} "// Written by compiler/cmake/embed_page.cmake from docs/language.md.
#include \"compiler/reference/explain_key.hpp\"

namespace director::compiler {

std::string_view language_page() {
  return${pieces};
}

} // namespace director::compiler
")
