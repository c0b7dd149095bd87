# SPDX-License-Identifier: MIT
# cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<the project> -D TARGET=<the board support> -D COMPILER=<the host's compiler>
#       -D QEMU=<qemu-system-arm> -P consumer.cmake
# Builds a separate project with a Director that is installed for the host: once for the host and once, with a toolchain file, for a Cortex-M3. Both
# programs must print the same.
file(REMOVE_RECURSE ${WORK})
foreach(component runtime compiler)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --component ${component} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(COPY ${SOURCE}/ DESTINATION ${WORK}/project)
file(COPY ${TARGET} DESTINATION ${WORK}/board/tests/system/arm)

function(build name)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/${name} -D CMAKE_PREFIX_PATH=${WORK}/prefix --no-warn-unused-cli ${ARGN}
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/${name} --parallel 2 RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${name} does not build:\n${output}")
  endif()
endfunction()

build(here -D CMAKE_CXX_COMPILER=${COMPILER})
build(there -D CMAKE_TOOLCHAIN_FILE=${WORK}/project/cortex_m3.cmake -D BOARD=${WORK}/board)
execute_process(COMMAND ${WORK}/here/ferry OUTPUT_VARIABLE here COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${QEMU} -M mps2-an385 -display none -monitor none -serial none -chardev stdio,id=host,signal=off
                        -semihosting-config enable=on,target=native,chardev=host -kernel ${WORK}/there/ferry
                OUTPUT_VARIABLE there TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
if(NOT here MATCHES "push Load.closing\n.*run Sail.*done\n$" OR NOT there STREQUAL here)
  message(FATAL_ERROR "On the host the program says\n${here}\nand on the Cortex-M3\n${there}")
endif()
