#pragma once
// SPDX-License-Identifier: MIT
// All connections of all viewers, in one thread, which never waits for one of them: a socket that cannot be read or
// written now is left for the next round, and one without progress is closed after a timeout.

#include "runtime/live/feed.hpp"
#include "runtime/live/http.hpp"
#include "runtime/live/site.hpp"

#include <atomic>
#include <chrono>
#include <deque>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace director::live {

class Server {
public:
  struct Options {
    std::size_t connections = 64;
    std::chrono::milliseconds interval{20};
    std::chrono::milliseconds patience{10'000};
  };

  /// `socket`: it listens, and belongs to the server from now on.
  Server(int socket, std::unique_ptr<Feed> feed, std::unique_ptr<Site> site, Options options);
  /// Ends all connections.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // From any thread.
  void allow(Commands commands) { site_->allow(std::move(commands)); }
  std::size_t viewers() const { return viewers_.load(std::memory_order_relaxed); }

private:
  using Clock = std::chrono::steady_clock;

  struct Connection {
    /// It sends a request; is sent an answer; is sent all events; has been sent all, and may still send something.
    enum class Stage { asking, answering, viewing, leaving };
    int socket = -1;
    Stage stage = Stage::asking;
    Clock::time_point since, moved; ///< when this stage began; when bytes were moved last
    std::string in;
    std::size_t ignored = 0; ///< bytes that a viewer has sent
    std::deque<Feed::Text> out;
    std::size_t at = 0; ///< bytes of the first of `out` that are sent already
    Place place;
    bool is_silent = false; ///< the client has ended its direction, and waits for the rest of its answer
  };

  void run();
  void wait();
  void take_connections();
  bool make_room();
  void serve(Connection& connection, short events);
  bool read(Connection& connection);
  void ask(Connection& connection);
  void fill(Connection& connection);
  bool write(Connection& connection);
  void push(Connection& connection, Feed::Text text) const;
  bool is_over(const Connection& connection) const;
  void enter(Connection& connection, Connection::Stage stage) const;
  static void end(Connection& connection);

  const int socket_;
  const std::unique_ptr<Feed> feed_;
  const std::unique_ptr<Site> site_;
  const Options options_;
  Http http_;
  std::vector<std::unique_ptr<Connection>> connections_;
  std::string last_event_id_; ///< the `Last-Event-ID` of the current request
  Clock::time_point now_, taken_, alive_, accepts_again_;
  std::atomic<std::size_t> viewers_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

} // namespace director::live
