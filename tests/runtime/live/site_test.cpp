// SPDX-License-Identifier: MIT
// Tests runtime/live/site.hpp.
#include "runtime/live/site.hpp"
#include "tests/runtime/live/courier_moments.hpp"

#include <catch2/catch.hpp>

#include <chrono>

using namespace director;
using namespace director::tests;
using live::Reply, live::Request, live::Site;

namespace {

struct Shown {
  explicit Shown(bool shown = true)
      : source{16},
        site{source.names, live::Page{"<html>", "default-src 'none'"}, "token", {"robot7"}} {
    if (shown) source.show();
  }
  /// The answer, as `200 text`.
  std::string call(const std::string& method, const std::string& path,
                   std::multimap<std::string, std::string> parameters = {}, const std::string& origin = "") {
    Request request{
        .method = method, .path = path, .parameters = std::move(parameters), .host = "localhost", .origin = origin};
    return text(site.answer(request, source.moments.look(), source.moments.until()));
  }
  static std::string text(const Reply& reply) {
    return std::to_string(reply.status) + (reply.body ? " " + *reply.body : "");
  }
  void allow() {
    const auto post = source.behaviour.post();
    site.allow({.request = [post](Index edge, Index level) { return post.request_row(edge, level); },
                .cancel = [post](Index edge) { return post.cancel_row(edge); },
                .cancel_all = [post] { return post.cancel_all(); },
                .set = [post](Index state, std::int32_t value) { return post.set_row(state, value); }});
  }
  CourierMoments source;
  Site site;
};

constexpr const char* no_token =
    "403 The address needs the token that the program printed when it began: http://.../TOKEN/\n";

} // namespace

TEST_CASE("the page is behind the token, and nothing is sent without it") {
  Shown shown;
  CHECK(shown.call("GET", "/token/") == "200 <html>");
  CHECK(shown.call("GET", "/token") == "308 The address ends with a slash.\n");
  CHECK(shown.call("GET", "/favicon.ico") == "204");
  for (const char* path : {"", "/", "/tokem/", "/toke/", "/tokens/", "//token/", "/./token/", "/x/../token/", "/TOKEN/",
                           "*", "http://localhost/token/"})
    CHECK(shown.call("GET", path) == no_token);
  for (const char* path : {"/token//", "/token/../token/", "/token/etc/passwd", "/token/index.html", "/token/events/"})
    CHECK(shown.call("GET", path).starts_with("404 There is nothing here: "));
}

TEST_CASE("other methods are refused, with a list of those that there are for the address") {
  Shown shown;
  const auto refused = [&](const std::string& method, const std::string& path) {
    const Reply reply = shown.site.answer({.method = method, .path = path, .host = "localhost"},
                                          shown.source.moments.look(), shown.source.moments.until());
    for (const auto& [name, value] : reply.headers) {
      if (name == "Allow") return Shown::text(reply) + value;
    }
    return Shown::text(reply);
  };
  for (const std::string method : {"PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT"}) {
    for (const char* path : {"/token/", "/token/why", "/token/events", "/token/nothing"})
      CHECK(refused(method, path) == "405 " + method + " is not allowed here, only GET and HEAD.\nGET, HEAD");
    CHECK(refused(method, "/token/set") == "405 " + method + " is not allowed here, only POST.\nPOST");
    CHECK(refused(method, "/") == no_token);
  }
  for (const char* method : {"GET", "HEAD"})
    CHECK(refused(method, "/token/cancel_all") == "405 A command is posted: curl -X POST ...\nPOST");
  shown.allow();
  for (const char* path : {"/token/", "/token/why", "/token/events"})
    CHECK(refused("POST", path) == "405 This is no command: POST is not allowed here, only GET and HEAD.\nGET, HEAD");
}

TEST_CASE("a request with a host name of others is refused, with or without the token") {
  Shown shown;
  Request request{.method = "GET", .path = "/token/", .host = "evil.example:80"};
  const Reply reply = shown.site.answer(request, shown.source.moments.look(), shown.source.moments.until());
  CHECK(Shown::text(reply) ==
        "403 This is not called \"evil.example:80\": use the address that the program printed.\n");
  request.host = "robot7:80";
  CHECK(shown.site.answer(request, shown.source.moments.look(), shown.source.moments.until()).status == 200);
}

TEST_CASE("every answer forbids caching, framing, and referrers") {
  Shown shown;
  const auto headers = [&](const char* path) {
    std::string out;
    for (const auto& [name, value] : shown.site
                                         .answer({.method = "GET", .path = path, .host = "localhost"},
                                                 shown.source.moments.look(), shown.source.moments.until())
                                         .headers)
      out += name + ": " + value + "\n";
    return out;
  };
  const std::string common = "Cache-Control: no-store\nReferrer-Policy: no-referrer\nX-Content-Type-Options: "
                             "nosniff\nCross-Origin-Resource-Policy: "
                             "same-origin\nContent-Security-Policy: default-src 'none'";
  CHECK(headers("/token/") == common + "\n");
  for (const char* path : {"/", "/token/events", "/token/why", "/favicon.ico"})
    CHECK(headers(path) == common + "; frame-ancestors 'none'\n");
}

TEST_CASE("why one group waits, or all waiting groups") {
  Shown shown;
  CHECK(
      shown.call("GET", "/token/why", {{"group", "Sing"}}) ==
      R"(200 {"t":0,"n":1,"groups":[{"group":"Sing","kind":"not_requested","text":"nothing requests Sing","notes":["Deliver may, and does not run","Rest may, and does not run"]}]})"
      "\n");
  CHECK(shown.call("GET", "/token/why") == "200 {\"t\":0,\"n\":1,\"groups\":[]}\n");
  shown.source.behaviour.step(std::chrono::seconds(2)); // nothing happens
  shown.source.moments.show(shown.source.behaviour.seen().view(), shown.source.queue.total());
  CHECK(shown.call("GET", "/token/why") == "200 {\"t\":2000000,\"n\":1,\"groups\":[]}\n");
  const live::Moment& before = shown.source.moments.look();
  shown.source.behaviour.step(std::chrono::seconds(3)); // nothing happens
  shown.source.moments.show(shown.source.behaviour.seen().view(), shown.source.queue.total());
  shown.source.behaviour.request<courier::Rest>();
  shown.source.behaviour.step(std::chrono::seconds(4));
  shown.source.moments.show(shown.source.behaviour.seen().view(), shown.source.queue.total());
  CHECK(Shown::text(shown.site.answer({.method = "GET", .path = "/token/why", .host = "localhost"}, before,
                                      shown.source.moments.until())) ==
        "200 {\"t\":3000000,\"n\":1,\"groups\":[]}\n"); // a later step is not this moment
  CHECK(shown.source.moments.look().view.now == 4'000'000);
  CHECK(shown.source.moments.until() == 4'000'000);
  CHECK(shown.call("GET", "/token/why", {{"group", "Sin\"g"}}) == "404 There is no group \"Sin\"g\".\n");
  Shown silent(false);
  CHECK(silent.call("GET", "/token/why") ==
        "503 The program has shown nothing yet: it calls show(behaviour) of its LiveView after each step.\n");
}

TEST_CASE("without a page the events are still sent") {
  CourierMoments source{16};
  const Site site{source.names, std::nullopt, "token", {}};
  CHECK(Shown::text(site.answer({.method = "GET", .path = "/token/", .host = "localhost"}, source.moments.look(),
                                source.moments.until())) ==
        "404 The program has no page: it gives LiveView `page` or `html`, what `directorc docs` wrote. What happens is "
        "at events, and why at why.\n");
  CHECK(site.answer({.method = "GET", .path = "/token/events", .host = "localhost"}, source.moments.look(),
                    source.moments.until())
            .stream);
}

TEST_CASE("commands are refused until the program allows them, and then are carried out") {
  Shown shown;
  for (const char* command : {"request", "cancel", "cancel_all", "set", "nothing"})
    CHECK(
        shown.call("POST", "/token/" + std::string(command), {{"task", "Rest"}}) ==
        "403 Commands are not allowed: the program has not called allow_commands(behaviour.post()) of its LiveView.\n");
  CHECK(shown.call("POST", "/tokem/cancel_all") == no_token);
  shown.allow();
  CHECK(shown.call("POST", "/token/request", {{"task", "Rest"}}) == "202 posted: request Rest\n");
  CHECK(shown.call("POST", "/token/set", {{"state", "Mood"}, {"value", "hurried"}}) ==
        "202 posted: set Mood hurried\n");
  CHECK(shown.call("POST", "/token/set", {{"state", "Battery"}, {"value", "-10"}}) == "202 posted: set Battery -10\n");
  shown.source.show();
  CHECK(shown.source.behaviour.state<courier::Rest>() == RunState::running);
  CHECK(shown.call("POST", "/token/cancel", {{"task", "Rest"}}) == "202 posted: cancel Rest\n");
  shown.source.show();
  CHECK(shown.source.behaviour.state<courier::Rest>() == RunState::none);
  CHECK(shown.call("POST", "/token/cancel_all") == "202 posted: cancel all\n");
  shown.site.allow({});
  CHECK(shown.call("POST", "/token/cancel_all").starts_with("403 "));
}

TEST_CASE("an unknown or repeated parameter is refused with a list of the known ones, and nothing is done") {
  Shown shown;
  shown.allow();
  CHECK(shown.call("GET", "/token/why", {{"gruop", "Sing"}}) ==
        "400 why has no parameter \"gruop\"; there is: group.\n");
  CHECK(shown.call("GET", "/token/why", {{"group", "Sing"}, {"group", "Rest"}}) ==
        "400 The parameter group is given more than once: why takes one.\n");
  CHECK(shown.call("GET", "/token/events", {{"group", "Sing"}}) ==
        "400 events has no parameter \"group\"; it takes none.\n");
  CHECK(shown.call("POST", "/token/request", {{"task", "Rest"}, {"lvel", "soon"}}) ==
        "400 request has no parameter \"lvel\"; there are: task, level.\n");
  CHECK(shown.call("POST", "/token/request", {{"task", "Rest"}, {"level", "soon"}, {"level", "now"}}) ==
        "400 The parameter level is given more than once: request takes one.\n");
  CHECK(shown.call("POST", "/token/cancel_all", {{"task", "Rest"}}) ==
        "400 cancel_all has no parameter \"task\"; it takes none.\n");
  CHECK(shown.call("POST", "/token/set", {{"State", "Mood"}, {"value", "calm"}}) ==
        "400 set has no parameter \"State\"; there are: state, value.\n");
  shown.source.show();
  CHECK(shown.source.behaviour.state<courier::Rest>() == RunState::none);
  CHECK(shown.call("GET", "/token/", {{"from", "mail"}}) == "200 <html>"); // parameters that programs add to links
}

TEST_CASE("a command that cannot be carried out is answered with the reason") {
  Shown shown;
  shown.allow();
  const auto post = [&](const char* command, std::multimap<std::string, std::string> parameters) {
    return shown.call("POST", "/token/" + std::string(command), std::move(parameters));
  };
  CHECK(post("request", {}) == "400 The task is missing: task=NAME; there are: Deliver, Rest.\n");
  CHECK(post("cancel", {{"task", "Sing"}}) == "404 \"Sing\" is not a root task; there are: Deliver, Rest.\n");
  CHECK(post("request", {{"task", "Deliver"}}) ==
        "409 not posted: the task carries data, which only the program can give\n");
  CHECK(post("request", {{"task", "Deliver"}, {"level", "soon"}}) ==
        "404 \"soon\" is not a level of Deliver; there are: normal, urgent.\n");
  CHECK(post("request", {{"task", "Deliver"}, {"level", ""}}) ==
        "404 \"\" is not a level of Deliver; there are: normal, urgent.\n");
  for (const char* level : {"normal", "urgent"}) // both are found
    CHECK(post("request", {{"task", "Deliver"}, {"level", level}}) ==
          "409 not posted: the task carries data, which only the program can give\n");
  for (const char* level : {"", "normal"})
    CHECK(post("request", {{"task", "Rest"}, {"level", level}}) ==
          "404 Rest has no named levels: it is requested without `level`.\n");
  CHECK(post("set", {{"state", "Mood"}}) == "400 A state and a value are needed: set?state=NAME&value=VALUE.\n");
  CHECK(post("set", {{"state", "Moot"}, {"value", "calm"}}) == "404 There is no state \"Moot\".\n");
  CHECK(post("set", {{"state", "Door"}, {"value", "open"}}) ==
        "409 \"Door\" is set by the behaviour itself: only external states are set from outside.\n");
  CHECK(post("set", {{"state", "Mood"}, {"value", "angry"}}) == "404 \"angry\" is no value of Mood.\n");
  for (const char* number : {"", "x", "1.5", "7 ", "9x"})
    CHECK(post("set", {{"state", "Battery"}, {"value", number}}) ==
          "400 \"" + std::string(number) + "\" is not a whole number.\n");
  for (const char* number : {"101", "3000000000", "-99999999999"})
    CHECK(post("set", {{"state", "Battery"}, {"value", number}}) ==
          "409 not posted: " + std::string(number) + " is not within the range of Battery\n");
  CHECK(post("jump", {}) == "404 There is no such command: there are request, cancel, cancel_all and set.\n");
  CHECK(shown.call("POST", "/token/cancel_all", {}, "http://evil.example") ==
        "403 A command is not taken from the page of another server, http://evil.example.\n");
  Request body{.method = "POST", .path = "/token/cancel_all", .host = "localhost", .has_body = true};
  CHECK(Shown::text(shown.site.answer(body, shown.source.moments.look(), shown.source.moments.until())) ==
        "413 A command has no body: all stands in the address, as in request?task=NAME.\n");
}
