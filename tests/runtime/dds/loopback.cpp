// Header: tests/runtime/dds/loopback.hpp. Test: the tests beside it.
// SPDX-License-Identifier: MIT
#include "tests/runtime/dds/loopback.hpp"

#include <cstdlib>
#include <random>

namespace director::tests {

std::uint32_t loopback_domain() {
  static const std::uint32_t domain = [] {
    std::random_device draw;
    const std::string tag = "director-test-" + std::to_string(draw()) + "-" + std::to_string(draw());
    const std::string settings =
        R"(<CycloneDDS><Domain Id="any"><General><Interfaces><NetworkInterface address="127.0.0.1" multicast="false"/>)"
        R"(</Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex>)"
        R"(<MaxAutoParticipantIndex>20</MaxAutoParticipantIndex><Peers><Peer Address="127.0.0.1"/></Peers><Tag>)" +
        tag + "</Tag></Discovery></Domain></CycloneDDS>";
    setenv("CYCLONEDDS_URI", settings.c_str(), 1);
    return 1 + static_cast<std::uint32_t>(draw() % 100); // their ports are below those that the system assigns
  }();
  return domain;
}

} // namespace director::tests
