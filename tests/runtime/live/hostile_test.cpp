// SPDX-License-Identifier: MIT
// Hostile clients of a live view: whatever they send, other viewers continue, and so does the view.
#include "tests/property/random.hpp"
#include "tests/runtime/live/client.hpp"
#include "tests/runtime/live/soccer_game.hpp"

#include <catch2/catch.hpp>

#include <thread>

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;

namespace {

struct Attacked {
  explicit Attacked(LiveView::Options options = {}) : view(soccer::names::all(), prepared(options)) {
    for (int i = 0; i < 10; ++i) game.step();
    while (!is_there()) std::this_thread::sleep_for(1ms);
  }
  /// Whether a client with the token gets an answer.
  bool is_there() const { return call(view.url(), get(view.url(), "why")).status == 200; }
  int status(const std::string& request) const { return call(view.url(), request).status; }

  LiveView view;
  SoccerGame game{&view};

private:
  static LiveView::Options prepared(LiveView::Options options) {
    options.interval = 1ms;
    return options;
  }
};

std::string with_headers(const std::string& url, std::size_t bytes, std::string_view line) {
  std::string more;
  while (more.size() + line.size() < bytes) more += line;
  return get(url, "why", more);
}

} // namespace

TEST_CASE("random bytes are refused") {
  Attacked attacked;
  property::Random random(1);
  for (int i = 0; i < 300; ++i) {
    std::string bytes(random.below(3000), '\0');
    for (char& each : bytes) each = static_cast<char>(random.below(256));
    const Caller caller(attacked.view.url());
    caller.send(bytes + "\r\n\r\n");
    const Response received = split(caller.read_all());
    if (received.status != 400 && received.status != 403) FAIL(received.status << " for " << bytes);
  }
  CHECK(attacked.is_there());
}

TEST_CASE("requests that are nearly right: a letter replaced, lost or doubled") {
  Attacked attacked;
  property::Random random(2);
  const std::string right = get(attacked.view.url(), "why", "Accept: */*\r\nLast-Event-ID: 7\r\n");
  for (int i = 0; i < 1000; ++i) {
    std::string wrong = right.substr(0, right.size() - 4);
    for (std::size_t changes = 1 + random.below(3); changes > 0; --changes) {
      const std::size_t at = random.below(wrong.size());
      switch (random.below(3)) {
      case 0: wrong[at] = static_cast<char>(random.below(256)); break;
      case 1: wrong.erase(at, 1 + random.below(10)); break;
      default: wrong.insert(at, wrong.substr(at, random.below(20)));
      }
    }
    const int status = attacked.status(wrong + "\r\n\r\n");
    if (status != 200 && status != 400 && status != 403 && status != 404 && status != 405 && status != 501)
      FAIL(status << " for " << wrong);
  }
  CHECK(attacked.is_there());
}

TEST_CASE("a request that is too long is refused, in any part") {
  Attacked attacked;
  const std::string& url = attacked.view.url();
  CHECK(attacked.status(with_headers(url, 4000, "A: b\r\n")) == 200);
  CHECK(attacked.status(with_headers(url, 7900, "Range: bytes=0-1\r\n")) == 200);
  CHECK(attacked.status(with_headers(url, 9000, "A: b\r\n")) == 431);
  CHECK(attacked.status(with_headers(url, 1'000'000, "A: b\r\n")) == 431);
  CHECK(attacked.status(get(url, std::string(9000, 'x'))) == 431);
  CHECK(attacked.status(get(url, std::string(7900, 'x'))) == 404);
  CHECK(attacked.status(get(url, "why?" + std::string(7900, '&'))) == 200);
  CHECK(attacked.status(get(url, std::string(2000, '%'))) == 404);
  CHECK(attacked.status(std::string(20'000'000, 'x')) == 431); // one line without an end
  CHECK(attacked.is_there());
}

TEST_CASE("no path reaches anything that is not served") {
  Attacked attacked;
  const std::string& url = attacked.view.url();
  for (const char* path : {"../../etc/passwd", "..%2f..%2fetc%2fpasswd", "%2e%2e/%2e%2e/etc/passwd", "....//etc/passwd",
                           "why%00.html", "//etc/passwd", "..\\..\\etc", "why/../../etc/passwd"}) {
    CAPTURE(path);
    CHECK(attacked.status(get(url, path)) == 404);
  }
}

TEST_CASE("without the token, or with a similar one, nothing is sent") {
  Attacked attacked;
  const std::string& url = attacked.view.url();
  const std::string token = token_of(url), host = " HTTP/1.1\r\nHost: " + authority_of(url) + "\r\n\r\n";
  std::string nearly = token;
  nearly.back() = nearly.back() == '0' ? '1' : '0';
  const Response refused = call(url, "GET /" + nearly + "/events" + host);
  CHECK(refused.status == 403);
  CHECK(refused.body == "The address needs the token that the program printed when it began: http://.../TOKEN/\n");
  for (const std::string& path : {std::string("/"), std::string("/events"), "/" + token.substr(1) + "/",
                                  "/" + token + token + "/", "/?" + token, "/x/" + token + "/"})
    CHECK(attacked.status("GET " + path + host) == 403);
  for (const char* name : {"evil.example", "localhost.evil.example", ""})
    CHECK(attacked.status("GET /" + token + "/ HTTP/1.1\r\nHost: " + name + "\r\n\r\n") == 403);
  CHECK(attacked.status("GET /" + token + "/ HTTP/1.1\r\n\r\n") == 403);
}

TEST_CASE("other methods, and bodies of any size, do nothing") {
  Attacked attacked;
  const std::string& url = attacked.view.url();
  for (const char* method : {"PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT"})
    CHECK(attacked.status(get(url, "", "", method)) == 405);
  CHECK(attacked.status(get(url, "", "", "BREW")) == 501);
  CHECK(call(url, get(url, "why", "", "HEAD")).body.empty());
  CHECK(attacked.status(get(url, "set", "Content-Length: 99999999999999999999\r\n", "POST")) == 413);
  CHECK(attacked.status(get(url, "set", "Transfer-Encoding: chunked\r\n", "POST") + "fffffff\r\n" +
                        std::string(1'000'000, 'x')) == 413);
  CHECK(attacked.is_there());
}

TEST_CASE("a client that sends a letter now and then, or nothing, excludes no others") {
  Attacked attacked({.connections = 8, .patience = 60s});
  const std::string& url = attacked.view.url();
  std::vector<Caller> slow;
  for (int i = 0; i < 40; ++i) {
    slow.emplace_back(url);
    slow.back().send("GET /");
    CHECK(attacked.is_there());
  }
}

TEST_CASE("a request that does not end is closed after a timeout") {
  Attacked attacked({.patience = 100ms});
  const Caller slow(attacked.view.url());
  while (slow.send("x")) { // until the connection is closed
    std::string received;
    if (!slow.read(received)) break;
    std::this_thread::sleep_for(5ms);
  }
  CHECK(attacked.is_there());
}

TEST_CASE("a viewer that goes on sending is disconnected") {
  const LiveView view{soccer::names::all(), {.interval = std::chrono::milliseconds(1)}};
  const Caller caller(view.url());
  REQUIRE(caller.send(get(view.url(), "events")));
  while (view.viewers() != 1) std::this_thread::sleep_for(1ms);
  for (std::string answer; caller.send(std::string(1000, 'x')) && caller.read(answer);) {}
  while (view.viewers() != 0) std::this_thread::sleep_for(1ms);
}

TEST_CASE("if viewers use all connections, the next one is refused, and gets a place when one leaves") {
  Attacked attacked({.connections = 4});
  const std::string& url = attacked.view.url();
  std::vector<Caller> viewers;
  for (std::size_t i = 0; i < 4; ++i) viewers.emplace_back(url).send(get(url, "events"));
  while (attacked.view.viewers() != 4) std::this_thread::sleep_for(1ms);
  const Response full = split(Caller(url).read_all());
  CHECK(full.status == 503);
  CHECK(full.body == "All 4 connections are taken: close a page, or give LiveView more `connections`.\n");
  viewers.pop_back();
  while (!attacked.is_there()) std::this_thread::sleep_for(1ms);
}

TEST_CASE("a view that may have no connection has one, so that it can be seen") {
  Attacked attacked({.connections = 0});
  CHECK(attacked.is_there());
}

TEST_CASE("many clients that connect and leave at once, also in the middle of an answer, leave nothing behind") {
  Attacked attacked;
  const std::string& url = attacked.view.url();
  property::Random random(3);
  std::vector<std::thread> crowd;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    crowd.emplace_back([&url, seed] {
      property::Random own(seed + 10);
      for (int i = 0; i < 500; ++i) {
        const Caller caller(url);
        const std::string request = get(url, own.below(2) == 0 ? "events" : "why");
        if (caller.connected()) caller.send(request.substr(0, own.below(request.size() + 1)));
      }
    });
  }
  for (int i = 0; i < 2000; ++i) attacked.game.step();
  for (std::thread& each : crowd) each.join();
  while (attacked.view.viewers() != 0) {
    attacked.game.step();
    std::this_thread::sleep_for(1ms);
  }
  CHECK(attacked.is_there());
}
