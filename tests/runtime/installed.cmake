# SPDX-License-Identifier: MIT
# For scripts that test an installed Director. They are called as
# `cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<the project> -D COMPILER=<compiler> -P <script>`.

# build_with_installed(<component> <public headers, as a regular expression>): installs Director with this component to WORK/prefix, checks that only
# the public headers of the component are installed, and builds the project with it.
function(build_with_installed component public)
  file(REMOVE_RECURSE ${WORK})
  foreach(each runtime compiler ${component})
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --component ${each} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  file(GLOB private ${WORK}/prefix/include/director/runtime/${component}/*)
  list(FILTER private EXCLUDE REGEX "/(${public})\\.hpp$")
  if(private)
    message(FATAL_ERROR "installed, but nobody's business: ${private}")
  endif()
  # The containers of the project are checked ones, of another layout than those of the installed Director.
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${WORK}/prefix
                          "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wconversion -Wshadow -Werror -D_GLIBCXX_DEBUG" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "the project does not build:\n${output}")
  endif()
endfunction()
