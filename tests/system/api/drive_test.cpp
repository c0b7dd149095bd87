// SPDX-License-Identifier: MIT
// Random programs around the interface: nothing that they do may break it. The sanitizers check more than the
// assertions here (preset asan; tests/system/threads for several threads).
#include "tests/system/api/drive.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>

namespace {

using namespace director::tests;

/// DIRECTOR_DRIVES=first:count drives other seeds.
std::pair<std::uint64_t, std::uint64_t> seeds() {
  const char* given = std::getenv("DIRECTOR_DRIVES");
  if (given == nullptr) return {1, 500};
  char* rest = nullptr;
  const std::uint64_t first = std::strtoull(given, &rest, 10);
  return {first, *rest == ':' ? std::strtoull(rest + 1, nullptr, 10) : 1};
}

TEST_CASE("random programs break nothing, however they misbehave") {
  const auto [first, count] = seeds();
  for (std::uint64_t seed = first; seed != first + count; ++seed) {
    Drive drive(seed);
    drive.go_on(400);
    drive.end();
    CAPTURE(seed);
    REQUIRE(drive.wrong() == "");
  }
}

TEST_CASE("the levels of a task have names, but for the first one of a task in a pack, which need not be named") {
  std::vector<std::string> named;
  for (director::Index row = 0; row < 1000; ++row) {
    if (*courier::names::level(row) != '\0') named.emplace_back(courier::names::level(row));
  }
  CHECK(named == std::vector<std::string>{"normal", "urgent", "fast"});
}

TEST_CASE("the same seed does the same") {
  Drive one(7), other(7);
  one.go_on(100), other.go_on(100);
  CHECK(one.wrong() == other.wrong());
}

} // namespace
