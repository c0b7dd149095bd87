// Header: runtime/live/http.hpp. Test: tests/runtime/live/http_test.cpp.
// SPDX-License-Identifier: MIT
//
// cpp-httplib parses the request and writes the head of the answer, from a text into a text. Its own server is not
// used: it has a thread for each connection, and reads lines of any length. Features of it that make a small request
// expensive are disabled: parts of an answer (Range) and compression.
#include "runtime/live/http.hpp"

#include <httplib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

namespace director::live {

namespace {

/// A connection for the library that has only the bytes received so far.
class Text final : public httplib::Stream {
public:
  explicit Text(std::string_view in) : in_(in) {}
  std::string out;

  bool is_readable() const override { return !in_.empty(); }
  bool is_writable() const override { return true; }
  ssize_t read(char* to, std::size_t most) override {
    const std::size_t count = std::min(most, in_.size());
    std::memcpy(to, in_.data(), count);
    in_.remove_prefix(count);
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* from, std::size_t count) override {
    out.append(from, count);
    return static_cast<ssize_t>(count);
  }
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return -1; }

private:
  std::string_view in_;
};

/// Whether the library must not see this line. It would refuse some ranges before they could be removed.
bool is_ignored(std::string_view line) {
  const auto same = [](char lower, char any) { return lower == std::tolower(static_cast<unsigned char>(any)); };
  constexpr std::array<std::string_view, 3> headers{"range:", "accept-encoding:", "expect:"};
  return std::any_of(headers.begin(), headers.end(), [&](std::string_view name) {
    return line.size() >= name.size() && std::equal(name.begin(), name.end(), line.begin(), same);
  });
}

std::string without_ignored(std::string_view request) {
  std::string out;
  while (!request.empty()) {
    const std::string_view line = request.substr(0, std::min(request.find('\n'), request.size() - 1) + 1);
    if (!is_ignored(line)) out.append(line);
    request.remove_prefix(line.size());
  }
  return out;
}

/// Whether the first line is right but for its method, which is a word that the library does not know.
bool has_unknown_method(std::string_view request) {
  const std::string_view line = request.substr(0, request.find("\r\n"));
  const std::size_t first = line.find(' '), second = line.find(' ', first + 1);
  if (first == 0 || first == std::string_view::npos || second == std::string_view::npos || second == first + 1)
    return false;
  const std::string_view method = line.substr(0, first), version = line.substr(second + 1);
  constexpr std::string_view marks = "!#$%&'*+-.^_`|~"; // of a word, beside letters and digits
  constexpr std::array<std::string_view, 10> known{"GET",     "HEAD",  "POST",  "PUT", "DELETE",
                                                   "CONNECT", "TRACE", "PATCH", "PRI", "OPTIONS"};
  return (version == "HTTP/1.1" || version == "HTTP/1.0") &&
         std::all_of(method.begin(), method.end(),
                     [&](char letter) {
                       return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
                              marks.find(letter) != std::string_view::npos;
                     }) &&
         std::find(known.begin(), known.end(), method) == known.end();
}

} // namespace

class Http::Library final : public httplib::Server {
public:
  explicit Library(Http::Handler handler) : handler_(std::move(handler)) {
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      take(request, response);
      return HandlerResponse::Handled;
    });
  }

  Answer answer(std::string_view request) {
    reply_ = {};
    handler_called_ = false;
    const std::string read = without_ignored(request);
    Text text(read);
    process(*this, text);
    // The library gives no answer to an invalid request, nor to one with a method that it does not know.
    if (!handler_called_ && has_unknown_method(request))
      return {.head = bare_answer("501 Not Implemented", "There is no such method here, only GET, HEAD and POST.\n")};
    if (!handler_called_) return {.head = bare_answer("400 Bad Request", "This is no request of HTTP/1.1.\n")};
    return {std::move(text.out), std::move(reply_.body), reply_.stream};
  }

private:
  /// Since version 0.16 it also calls for the addresses of both ends.
  template <class Self>
  static void process(Self& self, httplib::Stream& text) {
    bool closed = false;
    if constexpr (requires { self.process_request(text, true, closed, nullptr); })
      self.process_request(text, true, closed, nullptr);
    else
      self.process_request(text, "", 0, "", 0, true, closed, nullptr);
  }

  void take(const httplib::Request& from, httplib::Response& to) {
    if (from.get_header_value_count("Host") > 1) return; // invalid: another program may read the other one
    const auto header = [&](const char* name) { return from.get_header_value(name); };
    Request request{.method = from.method,
                    .path = from.path,
                    .parameters = from.params,
                    .host = header("Host"),
                    .origin = header("Origin"),
                    .last_event = header("Last-Event-ID"),
                    .has_body = from.has_header("Transfer-Encoding") ||
                                (from.has_header("Content-Length") && header("Content-Length") != "0")};
    handler_called_ = true;
    reply_ = handler_(request);
    to.status = reply_.status;
    for (const auto& [name, value] : reply_.headers) to.set_header(name, value);
    // Only the head is used: the body is sent as it is.
    if (reply_.stream)
      to.set_content_provider(reply_.type, [](std::size_t, httplib::DataSink&) { return false; });
    else if (reply_.body != nullptr && !reply_.body->empty())
      to.set_content_provider(reply_.body->size(), reply_.type,
                              [](std::size_t, std::size_t, httplib::DataSink&) { return false; });
    if (request.method == "HEAD") {
      reply_.body = nullptr;
      reply_.stream = false;
    }
  }

  Http::Handler handler_;
  Reply reply_;
  bool handler_called_ = false; ///< the handler was called for the current request
};

Http::Http(Handler handler) : library_(std::make_unique<Library>(std::move(handler))) {}

Http::~Http() = default;

Answer Http::answer(std::string_view request) { return library_->answer(request); }

std::string bare_answer(std::string_view status, std::string_view text) {
  std::string out = "HTTP/1.1 ";
  out.append(status).append("\r\nConnection: close\r\nContent-Type: text/plain; charset=utf-8\r\nContent-Length: ");
  return out.append(std::to_string(text.size())).append("\r\n\r\n").append(text);
}

} // namespace director::live
