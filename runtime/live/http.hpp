#pragma once
// SPDX-License-Identifier: MIT
// HTTP requests and their answers; the only place with the library that reads and writes them. A connection has one
// request, and ends after the answer.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::live {

struct Request {
  std::string method = {}, path = {};
  std::multimap<std::string, std::string> parameters = {};
  std::string host = {}, origin = {}, last_event = {}; ///< headers; empty if missing
  bool has_body = false;
};

struct Reply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body = {};
  std::vector<std::pair<std::string, std::string>> headers = {};
  bool stream = false; ///< messages without end follow the body
};

/// The bytes of an answer: `head`, then the body, if it is sent.
struct Answer {
  std::string head;
  std::shared_ptr<const std::string> body = {};
  bool stream = false;
};

class Http {
public:
  using Handler = std::function<Reply(const Request&)>;

  explicit Http(Handler handler);
  ~Http();
  Http(const Http&) = delete;
  Http& operator=(const Http&) = delete;

  /// `request`: up to and including the empty line. An invalid one is answered with 400, one with an unknown method
  /// with 501, without the handler.
  Answer answer(std::string_view request);

private:
  class Library;
  std::unique_ptr<Library> library_;
};

/// The answer to a connection that is refused: `503 Service Unavailable`, with a text.
std::string bare_answer(std::string_view status, std::string_view text);

} // namespace director::live
