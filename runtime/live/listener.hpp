#pragma once
// SPDX-License-Identifier: MIT
// A socket that listens for connections.

#include <cstdint>
#include <string>

namespace director::live {

struct Listener {
  int socket = -1;       ///< it does not block; -1: there is none
  std::string authority; ///< `127.0.0.1:8080`, `[::1]:8080`
  std::string error;     ///< the reason if there is none
};

/// `port`: 0: any that is free.
Listener listen_at(const std::string& address, std::uint16_t port);

} // namespace director::live
