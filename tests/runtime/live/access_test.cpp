// SPDX-License-Identifier: MIT
// Tests runtime/live/access.hpp.
#include "runtime/live/access.hpp"

#include <catch2/catch.hpp>

#include <set>

using namespace director::live;

TEST_CASE("no two tokens are the same, and each has 32 digits") {
  std::set<std::string> tokens;
  for (int i = 0; i < 1000; ++i) {
    const std::string token = new_token().value();
    CHECK(token.size() == 32);
    CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
    tokens.insert(token);
  }
  CHECK(tokens.size() == 1000);
}

TEST_CASE("a token is equal only letter by letter, with the same length") {
  CHECK(is_token("abcd", "abcd"));
  for (const char* other : {"", "a", "abc", "abce", "bbcd", "abcde", "abcdabcd", "ABCD"})
    CHECK_FALSE(is_token(other, "abcd"));
  CHECK_FALSE(is_token(std::string("abcd\0", 5), "abcd"));
}

TEST_CASE("names of this computer are an address, localhost, and its own names, with any port") {
  const std::vector<std::string> names{"robot7", "robot7.local"};
  for (const char* host : {"127.0.0.1", "127.0.0.1:8080", "10.0.0.3:1", "[::1]", "[::1]:8080", "localhost",
                           "LocalHost:9", "robot7", "Robot7.local:80"})
    CHECK(is_own_host(host, names));
  for (const char* host :
       {"", ":80", "evil.example", "127.0.0.1.evil.example", "localhost.evil.example", "robot8", "robot7.", "[::1",
        "[::1]x", "::1", "[evil]", "127.0.0.1 ", "127.0.0.1@evil", "127.0.0.1:80:80"})
    CHECK_FALSE(is_own_host(host, names));
}

TEST_CASE("the origin of a page of this server has the same host and port, and a program has none") {
  CHECK(is_own_origin("", "localhost:80"));
  CHECK(is_own_origin("http://localhost:80", "localhost:80"));
  for (const char* origin :
       {"null", "http://localhost", "http://localhost:81", "https://localhost:80", "http://evil", "localhost:80"})
    CHECK_FALSE(is_own_origin(origin, "localhost:80"));
}
