# SPDX-License-Identifier: MIT
# The CMake package that other projects find with find_package(Director): directorc, the runtime and director_add_behaviour. It works from an install
# prefix (CMAKE_PREFIX_PATH), also after that was moved, and from a build tree (Director_DIR=<build>/cmake). Each component is an export set of its
# own, so that it can be installed alone.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Director)
set(build_folder ${PROJECT_BINARY_DIR}/cmake)

# director_install(<component> <name of the export set> <target>...): installs the targets, and exports them from the build tree too.
function(director_install component export)
  install(TARGETS ${ARGN} EXPORT ${export}
          RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component})
  install(EXPORT ${export} NAMESPACE Director:: DESTINATION ${package_folder} COMPONENT ${component})
  export(EXPORT ${export} NAMESPACE Director:: FILE ${build_folder}/${export}.cmake)
endfunction()

director_install(runtime DirectorRuntimeTargets director_core director_hosted)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/director COMPONENT runtime FILES_MATCHING PATTERN *.hpp
        PATTERN dds EXCLUDE PATTERN live EXCLUDE)
# The sources are installed as well: a project for another machine compiles the runtime itself (DirectorConfig.cmake.in).
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime DESTINATION ${CMAKE_INSTALL_DATADIR}/director COMPONENT runtime FILES_MATCHING PATTERN *.cpp
        PATTERN dds EXCLUDE PATTERN live EXCLUDE)
if(TARGET directorc)
  director_install(compiler DirectorCompilerTargets directorc)
  foreach(module IN ITEMS DirectorBehaviour.cmake DirectorDocs.cmake embed_page.cmake)
    install(FILES ${CMAKE_CURRENT_LIST_DIR}/${module} DESTINATION ${package_folder} COMPONENT compiler)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/${module} ${build_folder}/${module} COPYONLY)
  endforeach()
  # The build tree has the JSON schemas, which editors use, and the headers of the runtime, which director-clang reads, at the same relative paths as
  # an install prefix: directorc searches for them relative to its own path.
  file(GLOB schemas CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/schemas/*.schema.json)
  install(FILES ${schemas} DESTINATION ${CMAKE_INSTALL_DATADIR}/director/schemas COMPONENT compiler)
  foreach(schema IN LISTS schemas)
    cmake_path(GET schema FILENAME name)
    configure_file(${schema} ${PROJECT_BINARY_DIR}/share/director/schemas/${name} COPYONLY)
  endforeach()
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include/director)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/runtime ${PROJECT_BINARY_DIR}/include/director/runtime SYMBOLIC)
endif()
if(TARGET director-clang)
  install(TARGETS director-clang EXPORT DirectorClangTargets RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/director COMPONENT clang)
  install(EXPORT DirectorClangTargets NAMESPACE Director:: DESTINATION ${package_folder} COMPONENT clang)
  export(EXPORT DirectorClangTargets NAMESPACE Director:: FILE ${build_folder}/DirectorClangTargets.cmake)
endif()

# The licence requires that each copy contains its text. The Debian packages have it in their file `copyright`, so they do not contain this component.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/director COMPONENT licence)

set(DIRECTOR_SOURCES ${CMAKE_INSTALL_DATADIR}/director)
set(DIRECTOR_INCLUDES ${CMAKE_INSTALL_INCLUDEDIR}/director)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/DirectorConfig.cmake.in ${build_folder}/installed/DirectorConfig.cmake
                              INSTALL_DESTINATION ${package_folder} PATH_VARS DIRECTOR_SOURCES DIRECTOR_INCLUDES
                              NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
set(DIRECTOR_SOURCES ${PROJECT_SOURCE_DIR})
set(DIRECTOR_INCLUDES ${PROJECT_SOURCE_DIR})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/DirectorConfig.cmake.in ${build_folder}/DirectorConfig.cmake
                              INSTALL_DESTINATION ${build_folder} INSTALL_PREFIX ${PROJECT_BINARY_DIR} PATH_VARS DIRECTOR_SOURCES DIRECTOR_INCLUDES
                              NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# ARCH_INDEPENDENT: the package may be found for any architecture, because the runtime is compiled from its sources if the library does not fit.
write_basic_package_version_file(${build_folder}/DirectorConfigVersion.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${build_folder}/installed/DirectorConfig.cmake ${build_folder}/DirectorConfigVersion.cmake DESTINATION ${package_folder}
        COMPONENT runtime)
