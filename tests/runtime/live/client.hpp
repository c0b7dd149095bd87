#pragma once
// SPDX-License-Identifier: MIT
// A client of a live view with plain sockets, so that a test can be slow, silent or invalid.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::tests {

/// A connection to a server of this computer.
class Caller {
public:
  /// `url`: of a LiveView. `buffer`: bytes that wait for a client that does not read; 0: the default of the system.
  explicit Caller(const std::string& url, int buffer = 0);
  Caller(Caller&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}
  Caller& operator=(Caller&&) = delete;
  ~Caller();

  int socket() const { return socket_; }
  bool connected() const { return socket_ >= 0; }
  /// Sends the text unchanged. False: the connection has ended.
  bool send(std::string_view bytes) const;
  /// All bytes until the server ends the connection.
  std::string read_all() const;
  /// The bytes received by now; nothing: the server has ended the connection.
  bool read(std::string& into) const;

private:
  int socket_ = -1;
};

/// A `GET` request. `path`: behind the token, `events`.
std::string get(const std::string& url, std::string_view path, std::string_view more = "",
                std::string_view method = "GET");

struct Response {
  int status = 0; ///< 0: no HTTP answer
  std::string head, body;
};
/// Sends the request, and reads the whole answer.
Response call(const std::string& url, const std::string& request);
Response split(const std::string& answer);

/// The host of a url, `127.0.0.1:8080`, and its token.
std::string authority_of(const std::string& url);
std::string token_of(const std::string& url);

/// Takes the complete messages out of a stream, in order.
struct Message {
  std::string event, id;
  std::vector<std::string> data;
};
std::vector<Message> take_messages(std::string& stream);

/// Compares the messages of one viewer with all events, a line each: none is missing, repeated or out of order, except
/// those that a line reports as missing.
class Follower {
public:
  /// Adds a message. Empty: no difference so far.
  std::string follow(const std::vector<Message>& messages, const std::vector<std::string>& happened);
  std::size_t at() const { return at_; }     ///< the events compared so far
  std::size_t gaps() const { return gaps_; } ///< the number of gaps
  std::size_t missed() const { return missed_; }
  bool begun() const { return begun_; }

private:
  std::size_t at_ = 0, gaps_ = 0, missed_ = 0;
  bool begun_ = false;
};

} // namespace director::tests
