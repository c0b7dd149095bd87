# SPDX-License-Identifier: MIT
# cmake -D BUILD=<Director's build tree> -D WORK=<folder> -D SOURCE=<the project> -D COMPILER=<compiler> -P consumer.cmake
# Builds the example of runtime/dds/README.md as a separate project, with an installed Director, and runs it.
include(${CMAKE_CURRENT_LIST_DIR}/../installed.cmake)
build_with_installed(dds "asker|bridge|outbox|plug|reply|settings")
# DDS uses only loopback, with a random domain and tag, so that other DDS programs do not take part.
string(RANDOM LENGTH 12 tag)
string(RANDOM LENGTH 2 ALPHABET 123456789 domain)
set(ENV{CYCLONEDDS_URI} "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface address=\"127.0.0.1\" multicast=\"false\"/></Interfaces>\
<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>20</MaxAutoParticipantIndex>\
<Peers><Peer Address=\"127.0.0.1\"/></Peers><Tag>${tag}</Tag></Discovery></Domain></CycloneDDS>")
execute_process(COMMAND ${WORK}/build/lamp ${domain} OUTPUT_VARIABLE said TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
if(NOT said STREQUAL "taken\n")
  message(FATAL_ERROR "the program said: ${said}")
endif()
