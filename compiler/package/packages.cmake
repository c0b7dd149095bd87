# SPDX-License-Identifier: MIT
# The manual pages, and the Debian packages that `cpack` builds in the build tree: director, and director-clang if that program is built.
# dpkg-shlibdeps finds the shared libraries on which the packages depend.
if(NOT TARGET directorc OR CMAKE_CROSSCOMPILING OR NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
set(VERSION ${PROJECT_VERSION})
set(package ${PROJECT_BINARY_DIR}/package)
find_program(DIRECTOR_GZIP gzip)
mark_as_advanced(DIRECTOR_GZIP)

# compressed(<variable> <file>): compresses the file, as Debian's policy requires, if gzip is found. Sets the variable to the path of the result.
function(compressed variable file)
  set(${variable} ${file} PARENT_SCOPE)
  if(DIRECTOR_GZIP)
    add_custom_command(OUTPUT ${file}.gz COMMAND ${DIRECTOR_GZIP} -9nfk ${file} DEPENDS ${file} COMMENT "" VERBATIM)
    set(${variable} ${file}.gz PARENT_SCOPE)
  endif()
endfunction()

set(manual ${package}/directorc.1)
add_custom_command(OUTPUT ${manual}
                   COMMAND ${CMAKE_COMMAND} -D DIRECTORC=$<TARGET_FILE:directorc> -D VERSION=${VERSION} -D PAGE=${CMAKE_CURRENT_LIST_DIR}/directorc.1.in
                           -D OUT=${manual} -P ${CMAKE_CURRENT_LIST_DIR}/manual.cmake
                   DEPENDS directorc ${CMAKE_CURRENT_LIST_DIR}/manual.cmake ${CMAKE_CURRENT_LIST_DIR}/directorc.1.in
                   COMMENT "Writing the manual page" VERBATIM)
compressed(page ${manual})
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in ${package}/changelog.Debian @ONLY)
compressed(changelog ${package}/changelog.Debian)
set(pages ${page})
# OPTIONAL: the page does not exist if only some targets were built.
install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT compiler OPTIONAL)
# director_debian(<package>): installs the files that only a Debian package has to contain.
function(director_debian name)
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/lintian-overrides.in ${package}/${name}.lintian-overrides @ONLY)
  install(FILES ${package}/${name}.lintian-overrides DESTINATION share/lintian/overrides RENAME ${name} COMPONENT debian-${name} EXCLUDE_FROM_ALL)
  install(FILES ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/copyright ${changelog} DESTINATION share/doc/${name} COMPONENT debian-${name} EXCLUDE_FROM_ALL)
endfunction()
director_debian(director)
set(CPACK_COMPONENTS_ALL runtime compiler debian-director)
set(suggested "graphviz, git, gcc-arm-none-eabi")
if(TARGET director_live)
  list(APPEND CPACK_COMPONENTS_ALL live)
  string(PREPEND suggested "libcpp-httplib-dev, pkgconf, ")
endif()

set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(whole_version ${VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
set(CPACK_DEBIAN_DIRECTOR_PACKAGE_NAME director)
set(CPACK_DEBIAN_DIRECTOR_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DIRECTOR_PACKAGE_RECOMMENDS "cmake (>= 3.20), g++ (>= 4:12)")
set(CPACK_DEBIAN_DIRECTOR_PACKAGE_SUGGESTS "director-clang (= ${whole_version}), ${suggested}")
set(CPACK_DEBIAN_DIRECTOR_DESCRIPTION "compiler and runtime for robot behaviours
A behaviour says in YAML what a robot has to do, who can do it, what it takes
and what must hold. directorc checks that as a whole, before the robot moves,
and writes C++20 for it; the bodies are written by hand.

This package has directorc, the runtime that the generated code needs, and
what CMake needs to use both.")

if(TARGET director-clang)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/director-clang.1.in ${package}/director-clang.1 @ONLY)
  compressed(page ${package}/director-clang.1)
  list(APPEND pages ${page})
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT clang OPTIONAL)
  director_debian(director-clang)
  list(APPEND CPACK_COMPONENTS_ALL clang debian-director-clang)
  set(CPACK_DEBIAN_SCANNER_PACKAGE_NAME director-clang)
  set(CPACK_DEBIAN_SCANNER_PACKAGE_SHLIBDEPS ON)
  # libclang-common-19-dev has Clang's own headers, such as stddef.h.
  set(CPACK_DEBIAN_SCANNER_PACKAGE_DEPENDS "director (= ${whole_version}), libclang-common-19-dev")
  set(CPACK_DEBIAN_SCANNER_DESCRIPTION "reader of C++ for the robot behaviours of Director
With it, directorc knows the enums and types that a behaviour names, holds
the bodies of a program against the behaviour (directorc verify), and writes
the bodies that are missing (directorc stubs).")
endif()
add_custom_target(director_manual ALL DEPENDS ${pages} ${changelog})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own description above
set(CPACK_PACKAGE_NAME director)
set(CPACK_PACKAGE_VENDOR Director)
set(CPACK_PACKAGE_CONTACT "Director <director@localhost.localdomain>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_SOURCE_GENERATOR "")
include(CPack)
cpack_add_component_group(director)
cpack_add_component_group(scanner)
foreach(component runtime compiler live debian-director)
  cpack_add_component(${component} GROUP director)
endforeach()
foreach(component clang debian-director-clang)
  cpack_add_component(${component} GROUP scanner)
endforeach()
