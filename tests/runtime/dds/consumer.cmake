# SPDX-License-Identifier: MIT
# cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<the project> -D COMPILER=<compiler> -P consumer.cmake
# The example of runtime/dds/README.md as a project of its own, with an installed Director.
file(REMOVE_RECURSE ${WORK})
foreach(component runtime compiler dds)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --component ${component} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB private ${WORK}/prefix/include/director/runtime/dds/*)
list(FILTER private EXCLUDE REGEX "/(asker|bridge|outbox|plug|reply|settings)\\.hpp$")
if(private)
  message(FATAL_ERROR "installed, but nobody's business: ${private}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${WORK}/prefix
                        "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wconversion -Wshadow -Werror" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the project does not build:\n${output}")
endif()
# A network of its own, inside this computer.
string(RANDOM LENGTH 12 tag)
string(RANDOM LENGTH 2 ALPHABET 123456789 domain)
set(ENV{CYCLONEDDS_URI} "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface address=\"127.0.0.1\" multicast=\"false\"/></Interfaces>\
<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>20</MaxAutoParticipantIndex>\
<Peers><Peer Address=\"127.0.0.1\"/></Peers><Tag>${tag}</Tag></Discovery></Domain></CycloneDDS>")
execute_process(COMMAND ${WORK}/build/lamp ${domain} OUTPUT_VARIABLE said TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
if(NOT said STREQUAL "taken\n")
  message(FATAL_ERROR "the program said: ${said}")
endif()
