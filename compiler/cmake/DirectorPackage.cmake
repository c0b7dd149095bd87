# What another CMake project finds with find_package(Director): directorc, the runtime, director_add_behaviour. It works from an installed tree
# (CMAKE_PREFIX_PATH) and from a build tree (Director_DIR=<build>/cmake) alike.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Director)
set(package_targets director_core director_hosted)
if(TARGET directorc)
  list(APPEND package_targets directorc)
endif()

install(TARGETS ${package_targets} EXPORT DirectorTargets)
install(EXPORT DirectorTargets NAMESPACE Director:: DESTINATION ${package_folder})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/director FILES_MATCHING PATTERN *.hpp)

set(build_folder ${PROJECT_BINARY_DIR}/cmake)
file(CONFIGURE OUTPUT ${build_folder}/DirectorConfig.cmake @ONLY CONTENT
     "include(\${CMAKE_CURRENT_LIST_DIR}/DirectorTargets.cmake)\ninclude(\${CMAKE_CURRENT_LIST_DIR}/DirectorBehaviour.cmake)\n")
configure_file(${CMAKE_CURRENT_LIST_DIR}/DirectorBehaviour.cmake ${build_folder}/DirectorBehaviour.cmake COPYONLY)
write_basic_package_version_file(${build_folder}/DirectorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${build_folder}/DirectorConfig.cmake ${build_folder}/DirectorConfigVersion.cmake ${build_folder}/DirectorBehaviour.cmake
        DESTINATION ${package_folder})
export(EXPORT DirectorTargets NAMESPACE Director:: FILE ${build_folder}/DirectorTargets.cmake)
