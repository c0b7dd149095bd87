#pragma once
// SPDX-License-Identifier: MIT
// Who calls a live view: sockets as they are, so that a test can be as slow, as silent and as wrong as anybody.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::tests {

/// A connection to a server of this computer.
class Caller {
public:
  /// `url`: of a LiveView. `buffer`: bytes that wait for who does not read; 0: as the system has it.
  explicit Caller(const std::string& url, int buffer = 0);
  Caller(Caller&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}
  Caller& operator=(Caller&&) = delete;
  ~Caller();

  int socket() const { return socket_; }
  bool connected() const { return socket_ >= 0; }
  /// As it is. False: nobody takes it any more.
  bool say(std::string_view bytes) const;
  /// All that comes until the other one ends.
  std::string hear_all() const;
  /// What came by now; nothing: the other one has ended.
  bool hear(std::string& into) const;

private:
  int socket_ = -1;
};

/// `GET`, with what belongs to it. `path`: behind the token, `events`.
std::string get(const std::string& url, std::string_view path, std::string_view more = "",
                std::string_view method = "GET");

struct Heard {
  int status = 0; ///< 0: no answer of HTTP
  std::string head, body;
};
/// Asks, and hears the whole answer.
Heard call(const std::string& url, const std::string& request);
Heard split(const std::string& answer);

/// Of a url, `127.0.0.1:8080`, and what stands behind that and its slash, without the last one: the token.
std::string authority_of(const std::string& url);
std::string token_of(const std::string& url);

/// The messages of a stream that are whole, in order; takes them out.
struct Message {
  std::string event, id;
  std::vector<std::string> data;
};
std::vector<Message> take_messages(std::string& stream);

/// Checks what one viewer got against all that happened, a line each: nothing is missing, twice or out of order, but
/// what a line says that is missing.
class Follower {
public:
  /// Empty: all is well so far.
  std::string follow(const std::vector<Message>& messages, const std::vector<std::string>& happened);
  std::size_t at() const { return at_; }     ///< events that are behind it
  std::size_t gaps() const { return gaps_; } ///< how often some were missing
  std::size_t missed() const { return missed_; }
  bool begun() const { return begun_; }

private:
  std::size_t at_ = 0, gaps_ = 0, missed_ = 0;
  bool begun_ = false;
};

} // namespace director::tests
