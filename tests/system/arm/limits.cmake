# SPDX-License-Identifier: MIT
# cmake -D REPORT=<what sizes.cmake wrote> -D MOST_LAMP=<bytes> -D MOST_SOCCER=<bytes> -D MOST_OBJECT=<bytes> -P limits.cmake
# Compares the sizes in REPORT with their limits. Each build has the same sizes, so a larger one is due to a change of the code or of the compiler.
file(READ ${REPORT} line)
string(STRIP "${line}" line)
string(REPLACE " " ";" sizes "${line}")
list(GET sizes 0 processor)
list(GET sizes 3 object)
list(GET sizes 4 lamp)
list(GET sizes 5 soccer)
message("${processor}: one task ${lamp}, soccer ${soccer}, its Behaviour ${object} bytes")
foreach(what lamp soccer object)
  string(TOUPPER MOST_${what} most)
  if(${what} GREATER ${${most}})
    message(SEND_ERROR "${what} takes ${${what}} bytes on a ${processor}, and ${${most}} at most are expected (tests/system/arm/CMakeLists.txt). "
                       "`arm-none-eabi-nm -S --size-sort` of the programs in linked/ says where they are; a part of the engine that the tables do not "
                       "use may be linked by a reference that is not DIRECTOR_PART (runtime/core/base/parts.hpp).")
  endif()
endforeach()
