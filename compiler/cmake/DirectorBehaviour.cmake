# director_add_behaviour(<target> <file.yaml>)
#
# Checks the behaviour with directorc, generates its C++ into the build tree and makes it part of <target>: its sources, its include path (so that
# `#include "<behaviour>.hpp"` finds the header) and the runtime. Findings of level error stop the build. The C++ is generated again when the file,
# anything it imports, or directorc itself changes, and only then.
#
# The behaviour's name, which names the outputs, is read from the file's key `behaviour` when CMake configures.
function(director_add_behaviour target file)
  if(NOT TARGET ${target})
    message(FATAL_ERROR "director_add_behaviour: there is no target ${target}; add_executable or add_library comes first")
  endif()
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "director_add_behaviour: there is no file ${file}")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} keys REGEX "^behaviour[ \t]*:")
  string(REGEX MATCH "^behaviour[ \t]*:[ \t]*[\"']?([A-Za-z_][A-Za-z0-9_]*)" found "${keys}")
  if(NOT found)
    message(FATAL_ERROR "director_add_behaviour: ${file} has no key behaviour at its top level; only a behaviour can be generated, not a module alone")
  endif()
  set(behaviour ${CMAKE_MATCH_1})

  set(folder ${CMAKE_CURRENT_BINARY_DIR}/director/${target}/${behaviour})
  set(outputs ${folder}/${behaviour}.hpp ${folder}/${behaviour}.cpp ${folder}/manifest.json)
  set(depfile ${folder}/${behaviour}.d)
  # directorc leaves a file alone that says the same already. Ninja remembers that it looked; Make only knows what is newer.
  set(renew "")
  if(NOT CMAKE_GENERATOR MATCHES Ninja)
    set(renew COMMAND ${CMAKE_COMMAND} -E touch_nocreate ${outputs})
  endif()
  add_custom_command(
    OUTPUT ${outputs}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND Director::directorc generate ${file} -o ${folder} --depfile ${depfile}
    ${renew}
    DEPENDS ${file} $<TARGET_FILE:Director::directorc>
    DEPFILE ${depfile}
    COMMENT "Generating the behaviour ${behaviour}"
    VERBATIM)
  target_sources(${target} PRIVATE ${outputs})
  target_include_directories(${target} PUBLIC ${folder})
  target_link_libraries(${target} PUBLIC Director::core)
endfunction()
