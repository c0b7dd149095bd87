# What the rooms' CMakeLists.txt share. A room is a folder of sources that becomes one static library; its files are globbed, so that adding a file
# touches no CMake file.

# Warnings for Director's own code only: nothing of it reaches who links a room.
add_library(director_warnings INTERFACE)
target_compile_options(director_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                                                   $<$<BOOL:${DIRECTOR_WERROR}>:-Werror>)
# Clang blames whoever sorts stably for a deprecated function that libstdc++ 12 itself calls.
target_compile_options(director_warnings INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)

# director_room(<target> <alias> FOLDER <folder> [EXCLUDE <regex>...] [LINK <library>...] [PRIVATE_LINK <library>...] [PRECOMPILE <header>...])
# PRECOMPILE names headers from outside that many of the room's sources include: with DIRECTOR_PCH they are read once. A room without a source yet is an interface library, so that the rooms can be furnished in any order.
function(director_room target alias)
  cmake_parse_arguments(room "" "FOLDER" "EXCLUDE;LINK;PRIVATE_LINK;PRECOMPILE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${room_FOLDER}/*.cpp)
  foreach(pattern IN LISTS room_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX ${pattern})
  endforeach()
  if(sources)
    add_library(${target} STATIC ${sources})
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/director>)
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_link_libraries(${target} PUBLIC ${room_LINK} PRIVATE ${room_PRIVATE_LINK})
    # Its options, not the library itself: who installs a room does not have to install the warnings.
    target_compile_options(${target} PRIVATE $<TARGET_PROPERTY:director_warnings,INTERFACE_COMPILE_OPTIONS>)
    if(DIRECTOR_FUZZABLE)
      target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    if(DIRECTOR_PCH AND room_PRECOMPILE)
      target_precompile_headers(${target} PRIVATE ${room_PRECOMPILE})
      # With the time in it, ccache would never see the same header twice.
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
    endif()
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                   $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/director>)
    target_compile_features(${target} INTERFACE cxx_std_20)
    target_link_libraries(${target} INTERFACE ${room_LINK})
  endif()
  add_library(Director::${alias} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${alias})
endfunction()
