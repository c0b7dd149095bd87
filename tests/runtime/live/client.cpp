// Header: tests/runtime/live/client.hpp. Test: what it is used in.
// SPDX-License-Identifier: MIT
#include "tests/runtime/live/client.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

namespace director::tests {

namespace {
constexpr std::string_view scheme = "http://";
} // namespace

std::string authority_of(const std::string& url) {
  return url.substr(scheme.size(), url.find('/', scheme.size()) - scheme.size());
}
std::string token_of(const std::string& url) {
  const std::size_t begin = url.find('/', scheme.size()) + 1;
  return url.substr(begin, url.size() - 1 - begin);
}

Caller::Caller(const std::string& url, int buffer) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  if (buffer != 0) setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof(buffer));
  const std::string at = authority_of(url);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  to.sin_port = htons(static_cast<std::uint16_t>(std::stoi(at.substr(at.find(':') + 1))));
  if (connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof(to)) == 0) return;
  close(socket_);
  socket_ = -1;
}

Caller::~Caller() {
  if (socket_ >= 0) close(socket_);
}

bool Caller::send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::string Caller::read_all() const {
  std::string out;
  pollfd one{socket_, POLLIN, 0};
  while (poll(&one, 1, 60'000) == 1 && read(out)) {}
  return out;
}

bool Caller::read(std::string& into) const {
  std::array<char, 65'536> buffer{};
  const ssize_t count = recv(socket_, buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (count > 0) into.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

std::string get(const std::string& url, std::string_view path, std::string_view more, std::string_view method) {
  std::string out(method);
  return out.append(" /")
      .append(token_of(url))
      .append("/")
      .append(path)
      .append(" HTTP/1.1\r\nHost: ")
      .append(authority_of(url))
      .append("\r\n")
      .append(more)
      .append("\r\n");
}

Response split(const std::string& answer) {
  const std::size_t end = answer.find("\r\n\r\n");
  if (end == std::string::npos || !answer.starts_with("HTTP/1.1 ")) return {0, answer, {}};
  return {std::stoi(answer.substr(9, 3)), answer.substr(0, end + 2), answer.substr(end + 4)};
}

Response call(const std::string& url, const std::string& request) {
  const Caller caller(url);
  caller.send(request);
  return split(caller.read_all());
}

std::vector<Message> take_messages(std::string& stream) {
  std::vector<Message> out;
  std::size_t begin = 0;
  for (std::size_t end; (end = stream.find("\n\n", begin)) != std::string::npos; begin = end + 2) {
    Message& message = out.emplace_back();
    for (std::size_t at = begin; at < end + 1;) {
      const std::size_t line_end = stream.find('\n', at);
      const std::string line = stream.substr(at, line_end - at);
      if (line.starts_with("data: ")) message.data.push_back(line.substr(6));
      if (line.starts_with("event: ")) message.event = line.substr(7);
      if (line.starts_with("id: ")) message.id = line.substr(4);
      at = line_end + 1;
    }
  }
  stream.erase(0, begin);
  return out;
}

std::string Follower::follow(const std::vector<Message>& messages, const std::vector<std::string>& happened) {
  for (const Message& message : messages) {
    if (!message.event.empty()) continue; // `alive` and `standing` are no events
    std::size_t line = 0;
    bool moment = false;
    if (!begun_) {
      if (message.data.empty() || !message.data[0].starts_with("{\"director_trace\":1,"))
        return "it does not begin with a header";
      begun_ = moment = true;
      ++line;
    }
    if (const std::string dropped = R"({"event":"dropped","count":)";
        line < message.data.size() && message.data[line].starts_with(dropped)) {
      const std::size_t count = std::stoul(message.data[line].substr(dropped.size()));
      at_ += count;
      missed_ += count;
      ++gaps_;
      moment = true;
    }
    if (!moment) {
      for (; line < message.data.size(); ++line, ++at_) {
        if (at_ >= happened.size()) return "it has an event that did not happen: " + message.data[line];
        if (message.data[line] != happened[at_]) return "instead of " + happened[at_] + " comes " + message.data[line];
      }
    }
    if (message.id != std::to_string(at_))
      return "the message has the id " + message.id + " and ends at " + std::to_string(at_);
  }
  return {};
}

} // namespace director::tests
