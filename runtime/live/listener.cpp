// Header: runtime/live/listener.hpp. Test: tests/runtime/live/live_view_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/listener.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>
#include <system_error>

namespace director::live {

namespace {

constexpr int waiting =
    SOMAXCONN; ///< connections that are not accepted yet; a client that finds no place tries again after a second

std::string words(int error) { return std::generic_category().message(error); }

/// The port of the socket.
std::string port_of(int socket) {
  sockaddr_storage name{};
  socklen_t size = sizeof(name);
  std::array<char, NI_MAXSERV> port{};
  if (getsockname(socket, reinterpret_cast<sockaddr*>(&name), &size) != 0) return {};
  getnameinfo(reinterpret_cast<sockaddr*>(&name), size, nullptr, 0, port.data(), port.size(), NI_NUMERICSERV);
  return port.data();
}

int open_at(const addrinfo& place) {
  const int out = socket(place.ai_family, place.ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, place.ai_protocol);
  if (out < 0) return -1;
  const int yes = 1;
  setsockopt(out, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  if (bind(out, place.ai_addr, place.ai_addrlen) == 0 && listen(out, waiting) == 0) return out;
  const int error = errno;
  close(out);
  errno = error;
  return -1;
}

} // namespace

Listener listen_at(const std::string& address, std::uint16_t port) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  Listener out;
  if (const int error = getaddrinfo(address.c_str(), std::to_string(port).c_str(), &wanted, &found); error != 0) {
    out.error = "there is no address \"" + address + "\" (" + gai_strerror(error) +
                "): name one of this computer, such as 127.0.0.1";
    return out;
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, freeaddrinfo);
  const std::string host =
      found->ai_family == AF_INET6 && address.find(':') != std::string::npos ? "[" + address + "]" : address;
  out.socket = open_at(*found);
  if (out.socket >= 0) {
    out.authority = host + ":" + port_of(out.socket);
    return out;
  }
  const int error = errno;
  out.error = "cannot listen at " + host + ":" + std::to_string(port) + ": " + words(error);
  if (error == EADDRINUSE) out.error += "; another program has the port: give another one, or 0 for any that is free";
  if (error == EACCES) out.error += "; ports below 1024 are for root: give another one, or 0 for any that is free";
  if (error == EADDRNOTAVAIL) out.error += "; name an address of this computer, such as 127.0.0.1";
  return out;
}

} // namespace director::live
