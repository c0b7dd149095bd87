// Header: runtime/live/server.hpp. Test: tests/runtime/live/live_view_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/server.hpp"

#include "runtime/hosted/background_thread.hpp"
#include "runtime/hosted/within_a_day.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <new>
#include <thread>
#include <tuple>
#include <utility>

namespace director::live {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t longest_request = 8192;   ///< bytes; a browser's is about 500
constexpr std::size_t most_at_once = 256 << 10; ///< bytes for one connection before the next one
constexpr std::size_t most_connections_at_once = 64;
constexpr auto sign_of_life = 1s;
constexpr auto leaving_takes = 1s; ///< for bytes that still arrive, so that the answer is not cut off
constexpr auto no_socket_left = 100ms;

bool has_ended(ssize_t moved) {
  return moved == 0 || (moved < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
}

/// Viewers have a lower priority than the behaviour, whatever that has.
void yield_to_others() { setpriority(PRIO_PROCESS, 0, std::clamp(getpriority(PRIO_PROCESS, 0) + 10, 10, 19)); }

} // namespace

Server::Server(int socket, std::unique_ptr<Feed> feed, std::unique_ptr<Site> site, Options options)
    : socket_(socket),
      feed_(std::move(feed)),
      site_(std::move(site)),
      options_{std::max<std::size_t>(options.connections, 1), within_a_day(options.interval),
               within_a_day(options.patience)},
      http_([this](const Request& request) {
        last_event_id_ = request.last_event;
        return site_->answer(request, feed_->moment(), feed_->until());
      }) {
  try {
    thread_ = background_thread([this] { run(); });
  } catch (...) {
    ::close(socket_);
    throw;
  }
}

Server::~Server() {
  stop_.store(true);
  thread_.join();
  for (const auto& connection : connections_) end(*connection);
  ::close(socket_);
}

void Server::run() {
  yield_to_others();
  now_ = Clock::now();
  while (!stop_.load()) {
    try {
      wait();
    } catch (const std::bad_alloc&) { // viewers connect again, and the robot runs on
      for (const auto& each : connections_) end(*each);
      connections_.clear();
      std::this_thread::sleep_for(std::clamp(options_.interval, 20ms, 1000ms));
      now_ = Clock::now();
    }
  }
}

/// One round of all connections. The thread that steps does not wake this one, which would be a system call: so it
/// polls for events.
void Server::wait() {
  std::vector<pollfd> sockets{{socket_, static_cast<short>(now_ >= accepts_again_ ? POLLIN : 0), 0}};
  for (const auto& each : connections_) {
    const int wanted = (each->is_silent ? 0 : POLLIN) | (each->out.empty() ? 0 : POLLOUT);
    sockets.push_back({each->socket, static_cast<short>(wanted), 0});
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(taken_ + options_.interval - now_);
  poll(sockets.data(), sockets.size(), static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1000)));
  now_ = Clock::now();

  const bool take = now_ >= taken_ + options_.interval;
  if (take) {
    taken_ = now_;
    feed_->take();
  }
  const Feed::Text alive = now_ >= alive_ + sign_of_life ? feed_->alive() : nullptr;
  if (alive) alive_ = now_;
  for (std::size_t i = 0; i < connections_.size(); ++i) {
    Connection& each = *connections_[i];
    serve(each, sockets[i + 1].revents);
    if (each.stage != Connection::Stage::viewing) continue;
    if (take) fill(each);
    if (alive && each.out.empty()) push(each, alive);
  }
  std::erase_if(connections_, [](const auto& each) { return each->socket < 0; });
  if ((sockets[0].revents & POLLIN) != 0) take_connections();
  viewers_.store(static_cast<std::size_t>(std::ranges::count(connections_, Connection::Stage::viewing,
                                                             [](const auto& each) { return each->stage; })),
                 std::memory_order_relaxed);
}

void Server::take_connections() {
  for (std::size_t count = 0; count < most_connections_at_once; ++count) {
    auto connection = std::make_unique<Connection>(); // memory first: a socket without it would never be closed
    connections_.reserve(connections_.size() + 1);
    const int taken = accept4(socket_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (taken < 0) {
      // Without a free descriptor the connection stays pending, and would be reported again and again.
      if (errno != EAGAIN && errno != EWOULDBLOCK && errno != ECONNABORTED && errno != EINTR)
        accepts_again_ = now_ + no_socket_left;
      return;
    }
    if (connections_.size() >= options_.connections && !make_room()) {
      const std::string full =
          bare_answer("503 Service Unavailable",
                      "All " + std::to_string(options_.connections) +
                          " connections are taken: close a page, or give LiveView more `connections`.\n");
      std::ignore = send(taken, full.data(), full.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      ::close(taken);
      continue;
    }
    connection->socket = taken;
    enter(*connection, Connection::Stage::asking);
    connections_.push_back(std::move(connection));
  }
}

/// Closes the oldest connection without a complete request, so that silent clients cannot exclude others.
bool Server::make_room() {
  const auto oldest = std::ranges::min_element(connections_, {}, [](const auto& each) {
    const bool idle = each->stage == Connection::Stage::asking || each->stage == Connection::Stage::leaving;
    return std::pair(!idle, each->since);
  });
  if (oldest == connections_.end()) return false;
  Connection& connection = **oldest;
  if (connection.stage != Connection::Stage::asking && connection.stage != Connection::Stage::leaving) return false;
  end(connection);
  connections_.erase(oldest);
  return true;
}

void Server::serve(Connection& connection, short events) {
  const bool readable = (events & (POLLIN | POLLHUP | POLLERR)) != 0;
  if ((readable && !read(connection)) || is_over(connection)) return end(connection);
  if (connection.stage == Connection::Stage::asking) ask(connection);
  if (!connection.out.empty() && !write(connection)) return end(connection);
  if (connection.stage == Connection::Stage::answering && connection.out.empty()) {
    shutdown(connection.socket, SHUT_WR);
    enter(connection, Connection::Stage::leaving);
  }
}

/// Reads. False: the connection has ended, or a viewer sends too much: what is behind a request is ignored.
bool Server::read(Connection& connection) {
  std::array<char, 4096> buffer;
  const ssize_t count = recv(connection.socket, buffer.data(), buffer.size(), 0);
  if (count == 0 && connection.stage == Connection::Stage::answering && !connection.is_silent)
    return connection.is_silent = true;
  if (has_ended(count)) return false;
  if (count <= 0) return true;
  if (connection.stage == Connection::Stage::asking)
    connection.in.append(buffer.data(), static_cast<std::size_t>(count));
  else if (connection.stage == Connection::Stage::viewing)
    connection.ignored += static_cast<std::size_t>(count);
  return connection.ignored <= longest_request;
}

void Server::ask(Connection& connection) {
  const std::size_t end = connection.in.find("\r\n\r\n");
  if (end == std::string::npos && connection.in.size() < longest_request) return;
  Answer answer;
  if (end == std::string::npos || end + 4 > longest_request)
    answer.head = bare_answer("431 Request Header Fields Too Large", "A request has at most 8192 bytes.\n");
  else
    answer = http_.answer(std::string_view(connection.in).substr(0, end + 4));
  connection.in = {};
  push(connection, std::make_shared<const std::string>(std::move(answer.head)));
  if (answer.body) push(connection, std::move(answer.body));
  enter(connection, answer.stream ? Connection::Stage::viewing : Connection::Stage::answering);
  if (answer.stream) {
    connection.place = feed_->resume(last_event_id_).value_or(Place{});
    fill(connection);
  }
}

/// Sends new messages as long as the viewer takes them: for a viewer that does not, only one message and its place are
/// kept.
void Server::fill(Connection& connection) {
  while (connection.out.size() < 2) {
    Feed::Text text = feed_->next(connection.place);
    if (!text) return;
    push(connection, std::move(text));
    if (!write(connection)) return end(connection);
  }
}

/// The timeout begins now, if it had all messages before.
void Server::push(Connection& connection, Feed::Text text) const {
  if (connection.out.empty()) connection.moved = now_;
  connection.out.push_back(std::move(text));
}

/// Writes. False: the connection has ended.
bool Server::write(Connection& connection) {
  std::size_t left = most_at_once;
  while (!connection.out.empty() && left > 0) {
    const std::string_view rest = std::string_view(*connection.out.front()).substr(connection.at, left);
    const ssize_t count = rest.empty() ? 0 : send(connection.socket, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (!rest.empty() && has_ended(count)) return false;
    if (count < 0) return true;
    if (count > 0) connection.moved = now_;
    connection.at += static_cast<std::size_t>(count);
    left -= static_cast<std::size_t>(count);
    if (connection.at == connection.out.front()->size()) {
      connection.out.pop_front();
      connection.at = 0;
    }
  }
  return true;
}

bool Server::is_over(const Connection& connection) const {
  switch (connection.stage) {
  case Connection::Stage::asking: return now_ - connection.since > options_.patience / 2;
  case Connection::Stage::leaving: return now_ - connection.since > leaving_takes;
  case Connection::Stage::answering:
  case Connection::Stage::viewing: return !connection.out.empty() && now_ - connection.moved > options_.patience;
  }
  return true;
}

void Server::enter(Connection& connection, Connection::Stage stage) const {
  connection.stage = stage;
  connection.since = connection.moved = now_;
}

void Server::end(Connection& connection) {
  if (connection.socket >= 0) ::close(connection.socket);
  connection.socket = -1;
  connection.stage = Connection::Stage::leaving;
  connection.out.clear();
}

} // namespace director::live
