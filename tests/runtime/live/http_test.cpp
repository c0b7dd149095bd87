// SPDX-License-Identifier: MIT
// Tests runtime/live/http.hpp.
#include "runtime/live/http.hpp"

#include <catch2/catch.hpp>

using namespace director::live;

namespace {

/// The last request of the handler, as a line; it answers with a given text.
struct Asked {
  Reply reply{.body = std::make_shared<const std::string>("text")};
  std::string line;
  Http http{[this](const Request& request) {
    line = request.method + " " + request.path + " host=" + request.host + " origin=" + request.origin +
           " last=" + request.last_event;
    for (const auto& [name, value] : request.parameters) line += " " + name + "=" + value;
    if (request.has_body) line += " with a body";
    return reply;
  }};
};

} // namespace

TEST_CASE("a request has its path and parameters decoded, and its headers in any case") {
  Asked asked;
  const Answer answer = asked.http.answer(
      "GET /a%20b/why?group=Kick&x=%2b HTTP/1.1\r\nhOST: robot:80\r\nOrigin: http://o\r\nLAST-event-id: 7\r\n\r\n");
  CHECK(asked.line == "GET /a b/why host=robot:80 origin=http://o last=7 group=Kick x=+");
  CHECK(answer.head ==
        "HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: 4\r\nContent-Type: text/plain; charset=utf-8\r\n\r\n");
  CHECK(*answer.body == "text");
  CHECK_FALSE(answer.stream);
}

TEST_CASE("the answer to HEAD is the head of the answer to GET") {
  Asked asked;
  const Answer answer = asked.http.answer("HEAD / HTTP/1.1\r\nHost: a\r\n\r\n");
  CHECK(answer.head.find("Content-Length: 4\r\n") != std::string::npos);
  CHECK(answer.body == nullptr);
  asked.reply = {.type = "text/event-stream", .stream = true};
  CHECK_FALSE(asked.http.answer("HEAD / HTTP/1.1\r\nHost: a\r\n\r\n").stream);
}

TEST_CASE("a stream has no length, and ends with the connection") {
  Asked asked;
  asked.reply = {.type = "text/event-stream", .headers = {{"Cache-Control", "no-store"}}, .stream = true};
  const Answer answer = asked.http.answer("GET /events HTTP/1.1\r\nHost: a\r\n\r\n");
  CHECK(answer.head ==
        "HTTP/1.1 200 OK\r\nCache-Control: no-store\r\nConnection: close\r\nContent-Type: text/event-stream\r\n\r\n");
  CHECK(answer.stream);
}

TEST_CASE("the answer has neither ranges nor compression, and no request to continue") {
  Asked asked;
  const std::string plain = asked.http.answer("GET / HTTP/1.1\r\nHost: a\r\n\r\n").head;
  std::string parts = "Range: bytes=0-1";
  while (parts.size() < 8000) parts += ",0-1";
  for (const std::string& more : {parts, std::string("Range: items=0-5"), std::string("rANGE: bytes=abc"),
                                  std::string("Accept-Encoding: gzip, br"), std::string("Expect: 100-continue")}) {
    CHECK(asked.http.answer("GET / HTTP/1.1\r\nHost: a\r\n" + more + "\r\n\r\n").head == plain);
  }
}

TEST_CASE("a request says whether it has a body, which is not read") {
  Asked asked;
  asked.http.answer("POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 99999999999\r\nContent-Encoding: gzip\r\n\r\n");
  CHECK(asked.line == "POST / host=a origin= last= with a body");
  asked.http.answer("POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n");
  CHECK(asked.line == "POST / host=a origin= last= with a body");
  asked.http.answer("POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 0\r\n\r\n");
  CHECK(asked.line == "POST / host=a origin= last=");
}

TEST_CASE("an invalid request is refused without the handler, with an answer") {
  Asked asked;
  for (const char* request :
       {"\r\n\r\n", "nonsense\r\n\r\n", "BR=W / HTTP/1.1\r\n\r\n", "BREW HTTP/1.1\r\n\r\n", "BREW / HTTP/3.0\r\n\r\n",
        " / HTTP/1.1\r\n\r\n", "BREW  HTTP/1.1\r\n\r\n", "GET / HTTP/3.0\r\n\r\n", "PRI * HTTP/2.0\r\n\r\n",
        "GET /\r\n\r\n", "GET / HTTP/1.1\r\nHost: a\r\nhost: b\r\n\r\n", "\x16\x03\x01\r\n\r\n"}) {
    CAPTURE(request);
    CHECK(asked.http.answer(request).head ==
          "HTTP/1.1 400 Bad Request\r\nConnection: close\r\nContent-Type: text/plain; charset=utf-8\r\n"
          "Content-Length: 32\r\n\r\nThis is no request of HTTP/1.1.\n");
  }
  CHECK(asked.line.empty());
}

TEST_CASE("a method that is not known is refused without the handler, as such") {
  Asked asked;
  for (const char* request : {"BREW / HTTP/1.1\r\nHost: a\r\n\r\n", "PROPFIND /x HTTP/1.1\r\n\r\n",
                              "get / HTTP/1.0\r\nHost: a\r\n\r\n", "M-SEARCH * HTTP/1.1\r\n\r\n"}) {
    CAPTURE(request);
    CHECK(asked.http.answer(request).head ==
          "HTTP/1.1 501 Not Implemented\r\nConnection: close\r\nContent-Type: text/plain; charset=utf-8\r\n"
          "Content-Length: 55\r\n\r\nThere is no such method here, only GET, HEAD and POST.\n");
  }
  CHECK(asked.line.empty());
}
